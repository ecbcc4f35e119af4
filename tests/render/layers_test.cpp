// SPDX-License-Identifier: MIT
#include "render/layers.h"

#include "render/colors.h"
#include "tests/render/bed.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bedmix {
namespace {

TEST(Layers, TwoFieldsCannotShareTheCells) {
  EXPECT_EQ(missingFor(test::flatBed(), {Layer::pressure, Layer::voidage}).size(), 1u);
}

TEST(Layers, OfTheGasNeedGas) {
  const Layers all{Layer::particles, Layer::gas, Layer::voidage};
  EXPECT_TRUE(missingFor(test::flatBed(), all).empty());
  EXPECT_EQ(missingFor(test::gaslessBed(), all).size(), 2u);
  EXPECT_TRUE(missingFor(test::gaslessBed(), defaultLayers).empty());
}

TEST(Layers, OfTheGasNeedItInTheFrame) {
  const Scene scene = test::flatBed();
  Frame frame = test::movingFrame(scene);
  EXPECT_TRUE(missingFor(scene, frame, {Layer::gas}).empty());
  frame.gas.velocity.pop_back();
  const std::vector<Diagnostic> missing = missingFor(scene, frame, {Layer::gas});
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].trouble, Trouble::file);
  EXPECT_TRUE(missingFor(scene, frame, defaultLayers).empty());
}

/// Lightness L* (CIE 1976) of a colour.
double lightness(Rgba color) {
  const auto linear = [](std::uint8_t c) {
    const double v = c / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
  return 116.0 * std::cbrt(y) - 16.0;
}

TEST(Colors, OfTheFieldsGrowEvenlyLighter) {
  for (int i = 0; i < 10; ++i) {
    const double step = lightness(cividis((i + 1) / 10.0)) - lightness(cividis(i / 10.0));
    EXPECT_GT(step, 5.0) << "from " << i / 10.0;
    EXPECT_LT(step, 10.0) << "from " << i / 10.0;
  }
  EXPECT_EQ(cividis(-1.0), cividis(0.0));
  EXPECT_EQ(cividis(2.0), cividis(1.0));
}

TEST(Colors, OfTheSpeciesAreApartInGrey) {
  EXPECT_GT(lightness(restColor) - lightness(tracerColor), 50.0);
  EXPECT_GT(lightness(white) - lightness(restColor), 30.0);
}

}  // namespace
}  // namespace bedmix
