// SPDX-License-Identifier: MIT
#include "engine/core/gas_grid.h"
#include "render/draw_bed.h"
#include "render/scales.h"
#include "tests/render/bed.h"
#include "tests/render/drawn.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

using test::camera;
using test::drawn;
using test::em;

TEST(DrawList, ParticlesAreDiscsInTheOrderOfTheFrame) {
  const Frame frame = test::particlesAt({{0.010f, 0.020f}}, {{0.050f, 0.002f}, {0.096f, 0.400f}});
  const DrawList list = drawn(test::flatBed(), frame, {Layer::particles});
  ASSERT_EQ(list.discs.size(), 3u);
  EXPECT_EQ(list.discs[0].color, tracerColor);
  EXPECT_FLOAT_EQ(list.discs[0].at.x, 120.0f);  // 100 px + 10 mm
  EXPECT_FLOAT_EQ(list.discs[0].at.y, 860.0f);  // 900 px - 20 mm
  EXPECT_FLOAT_EQ(list.discs[0].radius, 4.0f);  // 2 mm
  EXPECT_EQ(list.discs[1].color, restColor);
  EXPECT_FLOAT_EQ(list.discs[2].at.x, 292.0f);
  EXPECT_FLOAT_EQ(list.discs[2].at.y, 100.0f);
  EXPECT_TRUE(list.lines.empty());
  EXPECT_TRUE(list.triangles.empty());
  EXPECT_TRUE(list.texts.empty());
}

TEST(DrawList, ParticlesOutOfViewAreLeftOut) {
  // The clip's upper edge is 450 mm above the floor; a disc reaches 2 mm from its centre.
  const Frame frame = test::particlesAt({{0.05f, 0.4515f}, {0.05f, 0.4525f}, {0.05f, 2.0f}}, {});
  EXPECT_EQ(drawn(test::flatBed(), frame, {Layer::particles}).discs.size(), 1u);
}

TEST(DrawList, ParticlesOverAFieldHaveARim) {
  const Scene scene = test::flatBed();
  const DrawList list = drawn(scene, test::movingFrame(scene), {Layer::particles, Layer::voidage});
  ASSERT_EQ(list.discs.size(), 2000u);
  EXPECT_EQ(list.discs[0].color, white);
  EXPECT_EQ(list.discs[1].color, tracerColor);
  EXPECT_EQ(list.discs[0].at, list.discs[1].at);
  EXPECT_LT(list.discs[1].radius, list.discs[0].radius);
}

TEST(DrawList, VelocityArrowsStartAtTheCentresAndScaleWithSpeed) {
  const Scene scene = test::flatBed();
  Frame frame = test::particlesAt({{0.010f, 0.020f}}, {{0.050f, 0.020f}, {0.070f, 0.020f}});
  frame.velocity = {{1.0f, 0.0f}, {0.0f, 0.5f}, {0.0f, 0.0f}};
  const DrawList list = drawn(scene, frame, {Layer::velocity});
  ASSERT_EQ(list.lines.size(), 2u);  // none for the one at rest
  const float pxPerSpeed = camera.length(arrowScale(scene, Layer::velocity));
  EXPECT_EQ(list.lines[0].from, camera.toPixel(frame.position[0]));
  EXPECT_FLOAT_EQ(list.lines[0].to.x, list.lines[0].from.x + pxPerSpeed);
  EXPECT_FLOAT_EQ(list.lines[0].to.y, list.lines[0].from.y);
  EXPECT_FLOAT_EQ(list.lines[1].to.y, list.lines[1].from.y - 0.5f * pxPerSpeed);  // upward
  EXPECT_GT(list.lines[0].head, 0.0f);
  EXPECT_EQ(list.lines[0].color, velocityColor);
}

TEST(DrawList, SamplingShowsTheCellsEdges) {
  Scene scene = test::flatBed();
  scene.sampling.minParticles = 0;  // none is hatched
  const DrawList list = drawn(scene, {}, {Layer::sampling});
  ASSERT_EQ(list.lines.size(), 5u + 16u);  // 4 x 15 cells
  EXPECT_EQ(list.lines[1].from, camera.toPixel(Vec2{0.024, 0.0}));
  EXPECT_EQ(list.lines[1].to, camera.toPixel(Vec2{0.024, 0.420}));
  EXPECT_EQ(list.lines[6].from, camera.toPixel(Vec2{0.0, 0.028}));
  EXPECT_EQ(list.lines[6].to, camera.toPixel(Vec2{0.096, 0.028}));
}

TEST(DrawList, AFieldColoursTheOpenCells) {
  const Scene scene = test::inclinedBed();
  const Frame frame = test::movingFrame(scene);
  const DrawList list = drawn(scene, frame, {Layer::voidage});
  const GasGrid grid = makeGasGrid(scene);
  std::size_t open = grid.cells();
  for (int row : grid.lowestRow) open -= static_cast<std::size_t>(row);
  ASSERT_EQ(list.triangles.size(), 2 * open);
  EXPECT_EQ(list.triangles[0].a, camera.toPixel(Vec2{grid.x[0], grid.y[1]}));
  EXPECT_EQ(list.triangles[0].b, camera.toPixel(Vec2{grid.x[1], grid.y[1]}));
  EXPECT_EQ(list.triangles[0].c, camera.toPixel(Vec2{grid.x[1], grid.y[0]}));
  EXPECT_EQ(list.triangles[0].color, cividis((frame.gas.voidage[0] - 0.4) / 0.6));
  EXPECT_EQ(list.triangles.back().color, cividis(1.0));  // empty freeboard
}

TEST(DrawList, GasArrowsAreCentredOnTheirCells) {
  const Scene scene = test::flatBed();
  Frame frame = test::movingFrame(scene);
  for (Vec2f& v : frame.gas.velocity) v = {};
  frame.gas.velocity[0] = {0.0f, 5.0f};
  const DrawList list = drawn(scene, frame, {Layer::gas});
  ASSERT_EQ(list.lines.size(), 2u);  // the rim, then the arrow
  EXPECT_EQ(list.lines[0].color, white);
  EXPECT_EQ(list.lines[1].color, gasColor);
  const Vec2f middle = (list.lines[1].from + list.lines[1].to) * 0.5f;
  EXPECT_NEAR(middle.x, camera.toPixel(Vec2{0.006, 0.006}).x, 1e-3);
  EXPECT_NEAR(middle.y, camera.toPixel(Vec2{0.006, 0.006}).y, 1e-3);
  EXPECT_LT(list.lines[1].to.y, list.lines[1].from.y);
}

TEST(DrawList, AnEmptyBedHasAPicture) {
  Scene scene = test::flatBed();
  scene.particles.count = 0;
  const DrawList list = drawn(scene, {}, defaultLayers);
  EXPECT_TRUE(list.discs.empty());
  EXPECT_FALSE(list.lines.empty());
  EXPECT_GT(colorRange(scene, Layer::pressure).high, 0.0);
}

TEST(DrawList, ScaleBarIsAsLongAsItSays) {
  DrawList list;
  drawScaleBar(list, test::flatBed(), camera, {50.0f, 990.0f}, em);
  ASSERT_EQ(list.lines.size(), 1u);
  ASSERT_EQ(list.texts.size(), 1u);
  EXPECT_EQ(list.texts[0].text, "20 mm");
  EXPECT_FLOAT_EQ(list.lines[0].to.x - list.lines[0].from.x, 40.0f);
  EXPECT_FLOAT_EQ(list.lines[0].from.x, 50.0f);
}

TEST(DrawList, PressureRangeHoldsTheBedsWeight) {
  const ColorRange range = colorRange(test::flatBed(), Layer::pressure);  // 1284 Pa
  EXPECT_DOUBLE_EQ(range.low, 0.0);
  EXPECT_DOUBLE_EQ(range.high, 2000.0);
}

TEST(DrawList, FieldsHaveTheirValuesColours) {
  const Scene scene = test::flatBed();
  Frame frame = test::movingFrame(scene);
  frame.gas.velocity[0] = {3.0f, -4.0f};
  EXPECT_DOUBLE_EQ(colorRange(scene, Layer::gasSpeed).high, 10.0);  // 2.6 m/s / 0.4 is 6.5
  EXPECT_EQ(drawn(scene, frame, {Layer::gasSpeed}).triangles[0].color, cividis(0.5));
  frame.gas.pressure[0] = 500.0f;
  EXPECT_EQ(drawn(scene, frame, {Layer::pressure}).triangles[0].color, cividis(0.25));
}

TEST(DrawList, FieldOfTemperatureIsColdToWarm) {
  Scene scene = test::flatBed();
  HeatSettings& heat = scene.effects.at<HeatSettings>().emplace();
  heat.temperature = 300.0;
  heat.wallTemperature = 400.0;
  heat.gas.emplace();
  heat.gas->temperature = 300.0;
  Frame frame = test::movingFrame(scene);
  frame.gas.temperature.assign(frame.gas.voidage.size(), 400.0f);
  EXPECT_EQ(drawn(scene, frame, {Layer::gasTemperature}).triangles[0].color, coolWarm(1.0));
}

TEST(DrawList, RoundNumbers) {
  EXPECT_DOUBLE_EQ(roundDown(0.032), 0.02);
  EXPECT_DOUBLE_EQ(roundDown(7.3), 5.0);
  EXPECT_DOUBLE_EQ(roundDown(1284.0), 1000.0);
  EXPECT_DOUBLE_EQ(roundDown(2.0), 2.0);
  EXPECT_DOUBLE_EQ(roundUp(0.032), 0.05);
  EXPECT_DOUBLE_EQ(roundUp(1.2), 2.0);
  EXPECT_DOUBLE_EQ(roundUp(7.3), 10.0);
  EXPECT_DOUBLE_EQ(roundUp(2.0), 2.0);
}

}  // namespace
}  // namespace bedmix
