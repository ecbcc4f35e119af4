// SPDX-License-Identifier: MIT
#include "render/gif_palette.h"

#include "render/colors.h"
#include "tests/render/film_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bedmix {
namespace {

std::vector<std::uint8_t> places(GifPalette& palette, const Image& picture) {
  std::vector<std::uint8_t> result(picture.rgba.size() / 4);
  palette.map(picture, result.data(), static_cast<std::size_t>(picture.size.width));
  return result;
}

/// Each colour of a cube `step` apart, in a row.
Image cube(int step) {
  Image image;
  for (int r = 0; r < 256; r += step)
    for (int g = 0; g < 256; g += step)
      for (int b = 0; b < 256; b += step)
        for (const int channel : {r, g, b, 255}) image.rgba.push_back(static_cast<std::uint8_t>(channel));
  image.size = {static_cast<int>(image.rgba.size() / 4), 1};
  return image;
}

/// Largest distance of a colour from the one that stands for it.
double worst(const Image& picture, const std::vector<std::uint8_t>& at, const GifPalette& palette) {
  double result = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Rgba is = palette.colors()[at[i]];
    const std::uint8_t* was = &picture.rgba[4 * i];
    result = std::max(result, std::hypot(is.r - was[0], is.g - was[1], is.b - was[2]));
  }
  return result;
}

TEST(GifPalette, FrequentColorsComeFirstAndAreExact) {
  GifPalette palette;
  places(palette, test::halves({64, 64}, 1));  // half white, a quarter black and a quarter green
  ASSERT_EQ(palette.colors().size(), 3u);
  EXPECT_EQ(palette.colors()[0], white);
  EXPECT_TRUE(palette.colors()[1] == tracerColor || palette.colors()[1] == restColor);
  EXPECT_FALSE(palette.colors()[1] == palette.colors()[2]);
}

TEST(GifPalette, GrowsAndNothingMoves) {
  GifPalette palette;
  const Image first = test::halves({64, 64}, 0);
  const auto before = places(palette, first);
  const std::size_t known = palette.colors().size();
  places(palette, cube(64));
  EXPECT_GT(palette.colors().size(), known);
  EXPECT_EQ(places(palette, first), before);
}

TEST(GifPalette, BlendsOfTwoColorsAreClose) {
  Image blends;
  for (int i = 0; i < 256; ++i)
    for (int c = 0; c < 4; ++c) {
      const double part = i / 255.0;
      blends.rgba.push_back(
          static_cast<std::uint8_t>(std::lround((1.0 - part) * (&restColor.r)[c] + part * (&white.r)[c])));
    }
  blends.size = {256, 1};
  GifPalette palette;
  const auto at = places(palette, blends);
  EXPECT_LT(worst(blends, at, palette), 10.0);
}

TEST(GifPalette, ManyColorsFillItAndTheRestTakesTheNearest) {
  GifPalette palette;
  const Image all = cube(8);
  const auto at = places(palette, all);
  EXPECT_EQ(palette.colors().size(), GifPalette::most);
  EXPECT_LT(*std::max_element(at.begin(), at.end()), GifPalette::most);
  // Later pictures make do with what there is.
  const auto colors = palette.colors();
  places(palette, cube(5));
  EXPECT_EQ(palette.colors(), colors);
}

}  // namespace
}  // namespace bedmix
