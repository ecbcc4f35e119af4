// SPDX-License-Identifier: MIT
#include "render/mkv_film.h"
#include "tests/render/decode.h"
#include "tests/render/film_pictures.h"
#include "tests/render/temp_folder.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

/// Every channel takes every value.
Image colorful(Size size, int number) {
  Image image;
  image.resize(size);
  std::uint32_t state = 1u + static_cast<std::uint32_t>(number);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    state = state * 1664525u + 1013904223u;
    image.rgba[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(state >> 24);
  }
  return image;
}

void film(const std::filesystem::path& path, Size size, int pictures) {
  Result<MkvFilm> film = MkvFilm::create(path, size, 60.0);
  ASSERT_TRUE(film) << film.problems[0].message;
  for (int i = 0; i < pictures; ++i) ASSERT_TRUE(film->add(colorful(size, i)));
  ASSERT_TRUE(film->finish());
}

TEST(Mkv, IsToTheBitWhatWasPutIn) {
  const test::TempFolder folder;
  for (const Size size : {Size{64, 48}, Size{33, 17}, Size{16, 16}}) {
    film(folder / "a.mkv", size, 31);
    const test::DecodedMovie movie = test::decode(folder / "a.mkv");
    EXPECT_EQ(movie.codec, "ffv1");
    ASSERT_EQ(movie.frames.size(), 31u);
    EXPECT_DOUBLE_EQ(movie.framesPerSecond, 60.0);
    EXPECT_NEAR(movie.duration, 31 / 60.0, 1e-3);  // Matroska counts milliseconds
    for (std::size_t i = 0; i < movie.frames.size(); ++i) {
      EXPECT_EQ(movie.frames[i].size, size);
      EXPECT_NEAR(movie.times[i], static_cast<double>(i) / 60.0, 1e-3);
      EXPECT_EQ(movie.frames[i].rgba, colorful(size, static_cast<int>(i)).rgba) << i;
    }
  }
}

TEST(Mkv, IsTheSameBytesTwice) {
  const test::TempFolder folder;
  film(folder / "a.mkv", {64, 64}, 10);
  film(folder / "b.mkv", {64, 64}, 10);
  EXPECT_EQ(test::bytesOf(folder / "a.mkv"), test::bytesOf(folder / "b.mkv"));
}

TEST(Mkv, LeavesOnlyItself) {
  const test::TempFolder folder;
  film(folder / "a.mkv", {64, 64}, 3);
  std::filesystem::remove(folder / "a.mkv");
  EXPECT_TRUE(folder.empty());
  {
    Result<MkvFilm> unfinished = MkvFilm::create(folder / "a.mkv", {64, 64}, 60.0);
    ASSERT_TRUE(unfinished);
    ASSERT_TRUE(unfinished->add(test::halves({64, 64}, 0)));
  }
  EXPECT_TRUE(folder.empty());
}

TEST(Mkv, OfAKilledProgramPlaysNearlyToItsEnd) {
  const test::TempFolder folder;
  Result<MkvFilm> film = MkvFilm::create(folder / "a.mkv", {64, 64}, 10.0);
  ASSERT_TRUE(film);
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(film->add(colorful({64, 64}, i)));
  std::filesystem::copy(folder / "a.mkv.part", folder / "left.mkv");
  EXPECT_GE(test::decode(folder / "left.mkv").frames.size(), 80u);
}

}  // namespace
}  // namespace bedmix
