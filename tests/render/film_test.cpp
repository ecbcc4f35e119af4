// SPDX-License-Identifier: MIT
#include "render/colors.h"
#include "render/film_sink.h"
#include "render/layout.h"
#include "tests/render/bed.h"
#include "tests/render/decode.h"
#include "tests/render/temp_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bedmix {
namespace {

constexpr Size size{64, 128};
constexpr Layers layers{Layer::particles};
constexpr Vec2f place{0.048f, 0.2f};

/// A bed of one big particle that is black before 0.2 s and green from then on.
Scene scene() {
  Scene bed = test::gaslessBed();
  bed.particles.diameter = 0.08;
  return bed;
}

/// Films 51 frames, one each 0.01 s from 0 to 0.5 s.
void film(const std::filesystem::path& path, FilmOptions options) {
  options.paint = {size, layers, 0};
  Result<FilmSink> sink = FilmSink::create(scene(), path, options);
  ASSERT_TRUE(sink) << sink.problems[0].message;
  for (int i = 0; i <= 50; ++i)
    sink->accept(i < 20 ? test::particlesAt({place}, {}, i * 0.01)
                        : test::particlesAt({}, {place}, i * 0.01));
  const Result<Done> done = sink->finish();
  ASSERT_TRUE(done) << done.problems[0].message;
}

/// Whether each picture shows the particle green.
std::vector<bool> green(const test::DecodedMovie& movie) {
  const Vec2f at = layoutPicture(scene(), size, layers).camera.toPixel(place);
  std::vector<bool> result;
  for (const Image& image : movie.frames)
    result.push_back(image.at(static_cast<int>(at.x), static_cast<int>(at.y)).g > restColor.g / 2);
  return result;
}

std::vector<bool> blackThenGreen(std::size_t black, std::size_t total) {
  std::vector<bool> result(total, true);
  std::fill_n(result.begin(), black, false);
  return result;
}

TEST(Film, ShowsEachFrameOnceAtItsOwnRate) {
  const test::TempFolder folder;
  film(folder / "a.mp4", {{}, 100.0, 1.0});
  EXPECT_EQ(green(test::decode(folder / "a.mp4")), blackThenGreen(20, 51));
}

TEST(Film, SkipsFramesWhenFast) {
  const test::TempFolder folder;
  film(folder / "a.mp4", {{}, 25.0, 1.0});  // at 0, 0.04, ... 0.48 s; 0.2 s is the sixth
  const test::DecodedMovie movie = test::decode(folder / "a.mp4");
  EXPECT_EQ(green(movie), blackThenGreen(5, 13));
  EXPECT_NEAR(movie.duration, 13 / 25.0, 1e-6);
}

TEST(Film, HoldsFramesWhenSlow) {
  const test::TempFolder folder;
  film(folder / "a.mp4", {{}, 60.0, 0.2});  // 1/300 s of bed a picture: three a frame, the last one once
  EXPECT_EQ(green(test::decode(folder / "a.mp4")), blackThenGreen(60, 151));
}

TEST(Film, TakesAPart) {
  const test::TempFolder folder;
  film(folder / "a.mp4", {{}, 100.0, 1.0, 0.15, 0.3});
  EXPECT_EQ(green(test::decode(folder / "a.mp4")), blackThenGreen(5, 16));
}

class FilmOfAKind : public ::testing::TestWithParam<std::string> {};

TEST_P(FilmOfAKind, ShowsTheSame) {
  const test::TempFolder folder;
  const std::filesystem::path file = folder / GetParam().c_str();
  film(file, {{}, 50.0, 0.5, 0.1, 0.4});
  EXPECT_EQ(green(test::decode(file)), blackThenGreen(10, 31));
}

TEST_P(FilmOfAKind, IsTheSameBytesTwice) {
  const test::TempFolder a, b;
  film(a / GetParam().c_str(), {});
  film(b / GetParam().c_str(), {});
  EXPECT_EQ(test::bytesOf(a / GetParam().c_str()), test::bytesOf(b / GetParam().c_str()));
}

INSTANTIATE_TEST_SUITE_P(Kinds, FilmOfAKind, ::testing::Values("a.mp4", "a.gif", "a.mkv"));

TEST(Film, LengthIsKnownBefore) {
  for (const FilmOptions& options :
       {FilmOptions{{}, 100.0, 1.0, 0.0, 0.5}, FilmOptions{{}, 60.0, 0.2, 0.0, 0.5},
        FilmOptions{{}, 25.0, 1.0, 0.15, 0.3}}) {
    const test::TempFolder folder;
    film(folder / "a.mp4", options);
    EXPECT_EQ(test::decode(folder / "a.mp4").frames.size(), static_cast<std::size_t>(picturesOf(options)));
  }
}

TEST(Film, OfNoKindIsAProblem) {
  const test::TempFolder folder;
  EXPECT_FALSE(FilmSink::create(scene(), folder / "a.avi", {{size, layers, 0}}));
  EXPECT_TRUE(folder.empty());
}

TEST(Film, WithoutAFrameIsAProblem) {
  const test::TempFolder folder;
  Result<FilmSink> sink =
      FilmSink::create(scene(), folder / "a.mp4", {{size, layers, 0}, 50.0, 1.0, 2.0, 3.0});
  ASSERT_TRUE(sink);
  sink->accept(test::particlesAt({place}, {}, 0.5));
  EXPECT_FALSE(sink->finish());
  sink = Diagnostic{};
  EXPECT_TRUE(folder.empty());
}

TEST(Film, RatesMustBePositive) {
  const test::TempFolder folder;
  EXPECT_FALSE(FilmSink::create(scene(), folder / "a.mp4", {{}, 0.0, 1.0}));
  EXPECT_FALSE(FilmSink::create(scene(), folder / "a.mp4", {{}, 50.0, -1.0}));
  EXPECT_TRUE(folder.empty());
}

}  // namespace
}  // namespace bedmix
