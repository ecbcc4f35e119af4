// SPDX-License-Identifier: MIT
#include "replay/analysis/crossings.h"

#include "tests/replay/analysis_frames.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bedmix::test {
namespace {

TEST(Crossings, NetFluxIsTheChangeOfTheMassAbove) {
  Scene scene = syntheticScene(false, false, 300);
  scene.floor.inclinationDeg = 18.0;
  Crossings analysis({scene, 30, 0.01});
  for (int i = 0; i < 30; ++i) analysis.accept(syntheticFrame(scene, i));
  const Frame first = syntheticFrame(scene, 0), last = syntheticFrame(scene, 29);
  const auto massAbove = [&](const Frame& frame, double height) {
    return particleMass(scene) * static_cast<double>(std::ranges::count_if(frame.position, [&](Vec2f at) {
             return double{at.y} - floorHeight(scene, double{at.x}) >= height;
           }));
  };
  const Table table = tableOf(analysis, "flux_horizontal");
  ASSERT_GT(table.rows(), 25u);
  const double area = scene.bed.width * scene.bed.thickness, time = last.time - first.time;
  for (std::size_t r = 1; r < table.rows(); ++r) {
    const double height = at(table, "height", r);
    EXPECT_NEAR(at(table, "net", r) * area * time, massAbove(last, height) - massAbove(first, height),
                1e-9 * particleMass(scene))
        << height;
    EXPECT_NEAR(at(table, "net", r), at(table, "up", r) - at(table, "down", r), 1e-12 * at(table, "up", r));
  }
}

TEST(Crossings, WhoGoesAroundPeriodicSidesDoesNotCrossTheMiddle) {
  Scene scene = syntheticScene(false, false, 1);
  for (const BedSides sides : {BedSides::walls, BedSides::periodic}) {
    scene.bed.sides = sides;
    Crossings analysis({scene, 3, 0.01});
    for (int i = 0; i < 3; ++i) analysis.accept(frameOf(0.01 * i, {{i % 2 ? 0.046 : 0.002, 0.01}}));
    EXPECT_EQ(tableOf(analysis, "flux_vertical").rows() == 0, sides == BedSides::periodic);
  }
}

TEST(Crossings, CountEachWayByItself) {
  // One particle goes up at the left in three frames, over the middle at 30 mm, and down at the right.
  const Scene scene = syntheticScene(false, false, 1);
  Crossings analysis({scene, 6, 0.01});
  const std::vector<Vec2> path{{0.01, 0.002}, {0.01, 0.013}, {0.01, 0.03},
                               {0.03, 0.03},  {0.03, 0.01},  {0.03, 0.002}};
  for (std::size_t i = 0; i < path.size(); ++i)
    analysis.accept(frameOf(0.01 * static_cast<double>(i), {path[i]}));
  const double one = particleMass(scene) / (0.05 * scene.bed.thickness);  // kg/(m s)
  const Table lines = tableOf(analysis, "flux_horizontal");
  ASSERT_EQ(lines.rows(), 8u);  // up to 28 mm
  for (std::size_t r = 1; r < lines.rows(); ++r) {
    EXPECT_NEAR(at(lines, "up", r), one / scene.bed.width, 1e-9);
    EXPECT_NEAR(at(lines, "down", r), one / scene.bed.width, 1e-9);
  }
  const Table middle = tableOf(analysis, "flux_vertical");
  ASSERT_EQ(middle.rows(), 8u);
  EXPECT_NEAR(at(middle, "height", 7), 0.030, 1e-12);
  EXPECT_NEAR(at(middle, "right", 7), one / 0.004, 1e-6);
  EXPECT_NEAR(at(middle, "net", 7), -one / 0.004, 1e-6);
  EXPECT_EQ(at(middle, "right", 6), 0.0);
}

}  // namespace
}  // namespace bedmix::test
