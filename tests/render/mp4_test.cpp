// SPDX-License-Identifier: MIT
#include "render/mp4_film.h"
#include "tests/render/decode.h"
#include "tests/render/film_pictures.h"
#include "tests/render/temp_folder.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

void film(const std::filesystem::path& path, Size size, double fps, int pictures) {
  test::filmHalves(Mp4Film::create(path, size, fps), size, pictures);
}

TEST(Mp4, IsWhatWasPutIn) {
  const test::TempFolder folder;
  film(folder / "a.mp4", {128, 64}, 25.0, 60);
  const test::DecodedMovie movie = test::decode(folder / "a.mp4");
  ASSERT_EQ(movie.frames.size(), 60u);
  EXPECT_EQ(movie.frames[0].size, (Size{128, 64}));
  EXPECT_DOUBLE_EQ(movie.framesPerSecond, 25.0);
  EXPECT_NEAR(movie.duration, 60 / 25.0, 1e-6);
  EXPECT_TRUE(movie.bt709Limited);
  EXPECT_TRUE(movie.yuv420);
  EXPECT_EQ(movie.tag, "avc1");      // what QuickTime looks for
  EXPECT_EQ(movie.profile, "High");  // 8 bits, 4:2:0
  for (std::size_t i = 0; i < movie.frames.size(); ++i) {
    EXPECT_NEAR(movie.times[i], static_cast<double>(i) / 25.0, 1e-6);
    test::expectNear(movie.frames[i].at(32, 48), tracerColor);
    test::expectNear(movie.frames[i].at(96, 48), restColor);
    test::expectNear(movie.frames[i].at(32, 16), i % 2 ? white : tracerColor);
  }
}

TEST(Mp4, OfAnOddSizeLosesNothing) {
  const test::TempFolder folder;
  film(folder / "a.mp4", {65, 33}, 50.0, 3);
  const test::DecodedMovie movie = test::decode(folder / "a.mp4");
  ASSERT_EQ(movie.frames.size(), 3u);
  EXPECT_EQ(movie.frames[0].size, (Size{66, 34}));
  test::expectNear(movie.frames[0].at(65, 33), restColor);
  test::expectNear(movie.frames[1].at(65, 1), white);
}

TEST(Mp4, StartsWithItsIndex) {
  const test::TempFolder folder;
  film(folder / "a.mp4", {64, 64}, 50.0, 10);
  const std::string bytes = test::bytesOf(folder / "a.mp4");
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
  EXPECT_EQ(bytes.find("moof"), std::string::npos);
}

TEST(Mp4, IsTheSameBytesTwice) {
  const test::TempFolder folder;
  film(folder / "a.mp4", {128, 64}, 29.97, 40);
  film(folder / "b.mp4", {128, 64}, 29.97, 40);
  EXPECT_EQ(test::bytesOf(folder / "a.mp4"), test::bytesOf(folder / "b.mp4"));
}

TEST(Mp4, LeavesOnlyItself) {
  const test::TempFolder folder;
  film(folder / "a.mp4", {64, 64}, 50.0, 10);
  std::filesystem::remove(folder / "a.mp4");
  EXPECT_TRUE(folder.empty());
}

TEST(Mp4, UnfinishedLeavesNothing) {
  const test::TempFolder folder;
  {
    Result<Mp4Film> movie = Mp4Film::create(folder / "a.mp4", {64, 64}, 50.0);
    ASSERT_TRUE(movie);
    for (int i = 0; i < 120; ++i) ASSERT_TRUE(movie->add(test::halves({64, 64}, i)));
  }
  EXPECT_TRUE(folder.empty());
}

TEST(Mp4, OfAKilledProgramPlaysUpToItsLastFragment) {
  const test::TempFolder folder;
  Result<Mp4Film> movie = Mp4Film::create(folder / "a.mp4", {64, 64}, 10.0);
  ASSERT_TRUE(movie);
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(movie->add(test::halves({64, 64}, i)));
  // What a kill now would leave: a fragment a second, the encoder's queue and the open fragment lost.
  std::filesystem::copy(folder / "a.mp4.part", folder / "left.mp4");
  const std::size_t left = test::decode(folder / "left.mp4").frames.size();
  EXPECT_GE(left, 10u);
  EXPECT_LE(left, 100u);
}

}  // namespace
}  // namespace bedmix
