// SPDX-License-Identifier: MIT
#include "render/draw_particles.h"

#include "render/scales.h"
#include "tests/render/bed.h"
#include "tests/render/drawn.h"

#include <gtest/gtest.h>

#include <set>

namespace bedmix {
namespace {

Style colored(ParticleColor color, std::int64_t classes = 4) {
  Style style{Layer::particles};
  style.color = color;
  style.classes = classes;
  return style;
}

std::vector<Rgba> colorsOf(const Scene& scene, const Frame& frame, const Style& style) {
  History history(scene, style);
  history.observe(frame);
  std::vector<Rgba> colors;
  for (const Disc& disc : test::drawn(scene, frame, style, history).discs) colors.push_back(disc.color);
  return colors;
}

Frame twoParticles() { return test::particlesAt({{0.01f, 0.1f}}, {{0.09f, 0.2f}}); }

TEST(ParticleColors, OfSpeedGoFromRestToTheEndOfTheRange) {
  const Scene scene = test::flatBed();
  const double high = colorRange(scene, ParticleColor::speed).high;
  EXPECT_DOUBLE_EQ(high, 2.0);  // 1.2 sqrt(g width) is 1.16 m/s
  Frame frame = twoParticles();
  frame.velocity = {{0.0f, 0.0f}, {0.6f * static_cast<float>(high), -0.8f * static_cast<float>(high)}};
  const Palette palette;
  EXPECT_EQ(colorsOf(scene, frame, colored(ParticleColor::speed)),
            (std::vector{discColor(palette, 0.0), discColor(palette, 1.0)}));
}

TEST(ParticleColors, OfSpinHaveASign) {
  Scene scene = test::flatBed();
  scene.contacts.friction.emplace();
  const auto high = static_cast<float>(colorRange(scene, ParticleColor::spin).high);
  Frame frame = twoParticles();
  frame.angularVelocity = {-high, 0.5f * high};
  EXPECT_EQ(colorsOf(scene, frame, colored(ParticleColor::spin)),
            (std::vector{coolWarm(-1.0), coolWarm(0.5)}));
}

TEST(ParticleColors, OfVoidageAreThoseOfTheCell) {
  const Scene scene = test::flatBed();
  Frame frame = test::movingFrame(scene);
  const GasFrame gas = frame.gas;
  frame = test::particlesAt({{0.0119f, 0.0001f}}, {{0.0121f, 0.43f}});  // the second above the gas grid
  frame.gas = gas;
  frame.gas.voidage.front() = 0.55f;
  frame.gas.voidage[26 * 8 + 1] = 0.7f;
  const Palette palette;
  EXPECT_EQ(colorsOf(scene, frame, colored(ParticleColor::voidage)),
            (std::vector{discColor(palette, 0.25), discColor(palette, 0.5)}));
}

TEST(ParticleColors, OfTemperaturesSpanAllThatTheSceneNames) {
  Scene scene = test::flatBed();
  HeatSettings& heat = scene.effects.at<HeatSettings>().emplace();
  heat.temperature = 300.0;
  heat.tracerTemperature = 400.0;
  heat.gas.emplace();
  heat.gas->temperature = 300.0;
  heat.gas->inletTemperature = 500.0;
  Frame frame = twoParticles();
  frame.temperature = {300.0f, 450.0f};
  EXPECT_EQ(colorsOf(scene, frame, colored(ParticleColor::temperature)),
            (std::vector{coolWarm(-1.0), coolWarm(0.5)}));
}

TEST(ParticleColors, OfIdsAreSpreadOverTheBed) {
  Scene scene = test::flatBed();
  scene.particles.count = 2;
  const Palette palette;
  EXPECT_EQ(colorsOf(scene, twoParticles(), colored(ParticleColor::id)),
            (std::vector{discColor(palette, 0.0), discColor(palette, 1.0)}));
}

TEST(ParticleColors, OfStripsAndHeightsStayThoseOfTheStart) {
  const Scene scene = test::flatBed();
  const Frame first = test::movingFrame(scene);
  Frame later = first;
  for (Vec2f& p : later.position) p.x = 0.096f - p.x;
  later.time += 1.0;
  for (const ParticleColor color : {ParticleColor::strips, ParticleColor::height}) {
    const Style style = colored(color, 6);
    History history(scene, style);
    history.observe(first);
    history.observe(later);
    const DrawList before = test::drawn(scene, first, style, history);
    const DrawList after = test::drawn(scene, later, style, history);
    ASSERT_EQ(before.discs.size(), after.discs.size());
    for (std::size_t i = 0; i < before.discs.size(); ++i)
      EXPECT_EQ(before.discs[i].color, after.discs[i].color) << i;
  }
}

TEST(ParticleColors, OfTwoClassesAreBlackAndGreen) {
  EXPECT_EQ(colorsOf(test::flatBed(), twoParticles(), colored(ParticleColor::strips, 2)),
            (std::vector{tracerColor, restColor}));
}

TEST(Trails, JoinThePlacesAndEndInADot) {
  const Scene scene = test::flatBed();
  Style style{Layer::trails};
  style.trails = {1};
  History history(scene, style);
  Frame frame = twoParticles();
  for (int i = 0; i < 3; ++i) {
    frame.time = 0.1 * i;
    frame.position[1].x = 0.05f + 0.01f * static_cast<float>(i);
    history.observe(frame);
  }
  const DrawList list = test::drawn(scene, frame, style, history);
  ASSERT_EQ(list.lines.size(), 6u);  // two stretches and a dot, after their rims
  EXPECT_EQ(list.lines[0].color, white);
  EXPECT_EQ(list.lines[3].from, test::camera.toPixel(Vec2f{0.05f, 0.2f}));
  EXPECT_EQ(list.lines[4].to, test::camera.toPixel(frame.position[1]));
  EXPECT_LT(list.lines[3].width, list.lines[4].width);
  EXPECT_EQ(list.lines[5].from, list.lines[5].to);
}

}  // namespace
}  // namespace bedmix
