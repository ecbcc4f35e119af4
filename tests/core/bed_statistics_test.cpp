// SPDX-License-Identifier: MIT
#include "engine/core/bed_statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

/// A scene whose particle weighs 1 kg and whose flux window holds 1 m3.
Scene plainScene() {
  Scene scene;
  scene.bed = {10.0, 20.0, 1.0, BedTop::open};
  scene.particles.diameter = 0.5;
  scene.particles.density = 6.0 / (std::numbers::pi * 0.125);
  scene.flux = {5.0, 1.0, 2.0};
  return scene;
}

void add(Frame& frame, float x, float y, float vx) {
  frame.position.push_back({x, y});
  frame.velocity.push_back({vx, 100.0f});
}

TEST(SolidsFlux, SumsWhatIsInTheWindow) {
  const Scene scene = plainScene();
  Frame frame;
  add(frame, 5.0f, 1.5f, -3.0f);    // leftward counts positive
  add(frame, 4.5f, 1.0f, 1.0f);     // the window's corners belong to it
  add(frame, 5.5f, 2.0f, -0.25f);   //
  add(frame, 4.49f, 1.5f, -50.0f);  // left, right, below and above of it
  add(frame, 5.51f, 1.5f, -50.0f);
  add(frame, 5.0f, 0.99f, -50.0f);
  add(frame, 5.0f, 2.01f, -50.0f);
  EXPECT_NEAR(solidsFlux(frame, scene), 3.0 - 1.0 + 0.25, 1e-12);
  EXPECT_EQ(solidsFlux(Frame{}, scene), 0.0);
}

TEST(SolidsFlux, HeightsCountFromTheInclinedFloor) {
  Scene scene = plainScene();
  scene.floor.inclinationDeg = 45.0;  // the floor stands at 5 m under the window
  Frame frame;
  add(frame, 5.0f, 1.5f, -50.0f);
  add(frame, 5.0f, 6.5f, -2.0f);
  EXPECT_NEAR(solidsFlux(frame, scene), 2.0, 1e-12);
}

TEST(PressureDrop, AveragesTheLowestOpenCellsByWidth) {
  GasGrid grid;
  grid.columns = 2;
  grid.rows = 2;
  grid.x = {0.0, 1.0, 4.0};
  grid.y = {0.0, 1.0, 2.0};
  grid.lowestRow = {0, 1};
  Frame frame;
  frame.gas.pressure = {100.0f, 0.0f, 7.0f, 20.0f};  // the cell at the lower right is blocked
  EXPECT_EQ(pressureDrop(frame, grid), (1.0 * 100.0 + 3.0 * 20.0) / 4.0);
}

TEST(BedHeight, IsThe95thPercentileAboveTheFloorPlusARadius) {
  Scene scene = plainScene();
  Frame frame;
  for (int i = 101; i >= 1; --i) add(frame, 2.0f, static_cast<float>(i), 0.0f);
  EXPECT_EQ(bedHeight(frame, scene), 96.0 + 0.25);
  scene.floor.inclinationDeg = 45.0;
  EXPECT_NEAR(bedHeight(frame, scene), 96.0 - 2.0 + 0.25, 1e-12);
  EXPECT_EQ(bedHeight(Frame{}, scene), 0.0);
}

TEST(TagTracer, HalvesTheBed) {
  const std::vector<Vec2f> at{{0.0f, 3.0f}, {1.0f, 1.0f}, {2.0f, 2.0f}, {4.0f, 1.0f}};
  using Tags = std::vector<std::uint8_t>;
  EXPECT_EQ(tagTracer(TracerRule::leftHalf, at, {}, 4.0), (Tags{1, 1, 0, 0}));
  EXPECT_EQ(tagTracer(TracerRule::rightHalf, at, {}, 4.0), (Tags{0, 0, 1, 1}));
  EXPECT_EQ(tagTracer(TracerRule::lowerHalf, at, {}, 4.0), (Tags{0, 1, 0, 1}));
  EXPECT_EQ(tagTracer(TracerRule::upperHalf, at, {}, 4.0), (Tags{1, 0, 1, 0}));
  EXPECT_EQ(tagTracer(TracerRule::species, at, {0, 2, 1, 0}, 4.0), (Tags{0, 1, 1, 0}));
  EXPECT_EQ(tagTracer(TracerRule::species, at, {}, 4.0), (Tags{0, 0, 0, 0}));
}

}  // namespace
}  // namespace bedmix
