// SPDX-License-Identifier: MIT
#include "render/film_kind.h"
#include "render/gif_film.h"
#include "tests/render/decode.h"
#include "tests/render/film_pictures.h"
#include "tests/render/temp_folder.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

void film(const std::filesystem::path& path, Size size, int delay, int pictures) {
  test::filmHalves(GifFilm::create(path, size, delay), size, pictures);
}

TEST(Gif, IsWhatWasPutIn) {
  const test::TempFolder folder;
  film(folder / "a.gif", {65, 33}, 3, 20);
  const test::DecodedMovie movie = test::decode(folder / "a.gif");
  EXPECT_EQ(movie.codec, "gif");
  ASSERT_EQ(movie.frames.size(), 20u);
  EXPECT_EQ(movie.frames[0].size, (Size{65, 33}));
  EXPECT_NEAR(movie.duration, 20 * 0.03, 1e-6);
  for (std::size_t i = 0; i < movie.frames.size(); ++i) {
    EXPECT_NEAR(movie.times[i], static_cast<double>(i) * 0.03, 1e-6);
    EXPECT_EQ(movie.frames[i].rgba, test::halves({65, 33}, static_cast<int>(i)).rgba) << i;
  }
}

TEST(Gif, BeginsAnewWhenItEnds) {
  const test::TempFolder folder;
  film(folder / "a.gif", {16, 16}, 2, 3);
  const std::string forever("NETSCAPE2.0\x03\x01\0\0", 15);
  EXPECT_NE(test::bytesOf(folder / "a.gif").find(forever), std::string::npos);
}

TEST(Gif, IsTheSameBytesTwice) {
  const test::TempFolder folder;
  film(folder / "a.gif", {64, 64}, 5, 10);
  film(folder / "b.gif", {64, 64}, 5, 10);
  EXPECT_EQ(test::bytesOf(folder / "a.gif"), test::bytesOf(folder / "b.gif"));
}

TEST(Gif, LeavesOnlyItself) {
  const test::TempFolder folder;
  film(folder / "a.gif", {64, 64}, 5, 3);
  std::filesystem::remove(folder / "a.gif");
  EXPECT_TRUE(folder.empty());
  {
    Result<GifFilm> unfinished = GifFilm::create(folder / "a.gif", {64, 64}, 5);
    ASSERT_TRUE(unfinished);
    ASSERT_TRUE(unfinished->add(test::halves({64, 64}, 0)));
  }
  EXPECT_TRUE(folder.empty());
}

TEST(Gif, RatesAreThoseOfWholeHundredths) {
  EXPECT_DOUBLE_EQ(fittingRate(FilmKind::gif, 25.0), 25.0);
  EXPECT_DOUBLE_EQ(fittingRate(FilmKind::gif, 30.0), 100.0 / 3.0);
  EXPECT_DOUBLE_EQ(fittingRate(FilmKind::gif, 60.0), 50.0);
  EXPECT_DOUBLE_EQ(fittingRate(FilmKind::gif, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(fittingRate(FilmKind::mp4, 30.0), 30.0);
}

}  // namespace
}  // namespace bedmix
