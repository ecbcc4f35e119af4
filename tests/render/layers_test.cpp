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

TEST(Layers, OfSpinNeedAngularVelocitiesInTheFrame) {
  Scene scene = test::gaslessBed();
  scene.contacts.friction.emplace();
  Style style{Layer::particles};
  style.color = ParticleColor::spin;
  Frame frame = test::movingFrame(scene);
  EXPECT_TRUE(missingFor(scene, frame, style).empty());
  frame.angularVelocity.clear();
  const std::vector<Diagnostic> missing = missingFor(scene, frame, style);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_NE(missing[0].message.find("needs angular velocities"), std::string::npos);
}

TEST(Layers, OfTemperatureNeedHeatAndTemperaturesInTheFrame) {
  Scene scene = test::flatBed();
  Frame frame = test::movingFrame(scene);
  Style style{Layer::particles, Layer::gasTemperature};
  style.color = ParticleColor::temperature;
  const std::vector<Diagnostic> without = missingFor(scene, style);
  ASSERT_EQ(without.size(), 2u);
  for (const Diagnostic& d : without) EXPECT_NE(d.message.find("has no [heat]"), std::string::npos);
  scene.effects.at<HeatSettings>().emplace().gas.emplace();
  EXPECT_TRUE(missingFor(scene, style).empty());
  EXPECT_EQ(missingFor(scene, frame, style).size(), 2u);
  frame.temperature.assign(frame.size(), 300.0f);
  frame.gas.temperature.assign(frame.gas.voidage.size(), 300.0f);
  EXPECT_TRUE(missingFor(scene, frame, style).empty());
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

TEST(Colors, OfWhatHasASignAreEvenlyDarkerToBothSides) {
  EXPECT_NEAR(lightness(coolWarm(0.0)), 80.0, 1.0);
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(lightness(coolWarm(side)), 37.7, 1.0);
    for (int i = 0; i < 10; ++i)
      EXPECT_LT(lightness(coolWarm(side * (i + 1) / 10.0)), lightness(coolWarm(side * i / 10.0)));
  }
  EXPECT_GT(coolWarm(1.0).r, coolWarm(1.0).b);
  EXPECT_GT(coolWarm(-1.0).b, coolWarm(-1.0).r);
}

TEST(Colors, OfInkStandOutFromAnyGround) {
  for (int r = 0; r < 256; r += 15)
    for (int g = 0; g < 256; g += 15)
      for (int b = 0; b < 256; b += 15) {
        const Rgba ground{static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g),
                          static_cast<std::uint8_t>(b)};
        // Contrast of at least 4.5 (WCAG 2.1, level AA).
        const auto luminance = [](Rgba c) { return std::pow((lightness(c) + 16.0) / 116.0, 3); };
        const double a = luminance(ground) + 0.05, i = luminance(paletteOn(ground).ink) + 0.05;
        EXPECT_GE(std::max(a, i) / std::min(a, i), 4.5) << r << ' ' << g << ' ' << b;
      }
  EXPECT_EQ(paletteOn(white).tracer, black);
  EXPECT_EQ(paletteOn(black).tracer, white);
}

TEST(Colors, OfTheSpeciesAreApartInGrey) {
  EXPECT_GT(lightness(restColor) - lightness(tracerColor), 50.0);
  EXPECT_GT(lightness(white) - lightness(restColor), 30.0);
}

}  // namespace
}  // namespace bedmix
