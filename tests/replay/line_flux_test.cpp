// SPDX-License-Identifier: MIT
#include "replay/analysis/line_flux.h"

#include "tests/replay/analysis_frames.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bedmix::test {
namespace {

TEST(LineFlux, NetThroughALineAcrossTheBedIsTheChangeOfMassBehindIt) {
  const Scene scene = syntheticScene(false, false, 300);
  const FluxLine slope{{-1.0, 0.02}, {1.0, 0.09}};  // beyond the walls, and not level
  LineFlux flux({scene, 20, 0.01}, slope, "line_1");
  for (int i = 0; i < 20; ++i) flux.accept(syntheticFrame(scene, i));
  const auto massAbove = [&](const Frame& frame) {
    return particleMass(scene) * static_cast<double>(std::ranges::count_if(frame.position, [&](Vec2f at) {
             return double{at.y} >= 0.02 + (double{at.x} + 1.0) * 0.035;
           }));
  };
  const Table table = tableOf(flux, "line_1");
  ASSERT_EQ(table.rows(), 19u);
  const double area = norm(slope.to - slope.from) * scene.bed.thickness;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    const Frame before = syntheticFrame(scene, static_cast<int>(r)),
                after = syntheticFrame(scene, static_cast<int>(r) + 1);
    EXPECT_EQ(at(table, "time", r), after.time);
    EXPECT_NEAR(at(table, "flux", r) * area * (after.time - before.time),
                massAbove(after) - massAbove(before), 1e-9 * particleMass(scene));
    EXPECT_GT(at(table, "to_right", r), 0.0);
  }
}

// Beside the seam: out at one side, in at the other.
TEST(LineFlux, GoesAroundPeriodicSides) {
  Scene scene = syntheticScene(false, false, 1);
  scene.bed.sides = BedSides::periodic;
  const double one = particleMass(scene) / (0.01 * 0.05 * scene.bed.thickness);
  const auto through = [&](double x, Vec2 from, Vec2 to) {
    LineFlux flux({scene, 2, 0.01}, {{x, 0.0}, {x, 0.05}}, "line_1");
    flux.accept(frameOf(0.0, {from}));
    flux.accept(frameOf(0.01, {to}));
    return at(tableOf(flux, "line_1"), "flux", 0);
  };
  for (const double x : {0.001, 0.047}) {
    EXPECT_NEAR(through(x, {0.046, 0.02}, {0.002, 0.03}), -one, 1e-9 * one);
    EXPECT_NEAR(through(x, {0.002, 0.02}, {0.046, 0.03}), one, 1e-9 * one);
  }
  EXPECT_EQ(through(0.024, {0.046, 0.02}, {0.002, 0.03}), 0.0);  // not through the middle
}

TEST(LineFlux, CountsWhatPassesBetweenItsEndsAndWhichWay) {
  const Scene scene = syntheticScene(false, false, 1);
  const FluxLine upright{{0.02, 0.0}, {0.02, 0.05}};
  const double one = particleMass(scene) / (0.01 * 0.05 * scene.bed.thickness);
  const auto through = [&](Vec2 from, Vec2 to) {
    LineFlux flux({scene, 2, 0.01}, upright, "line_1");
    flux.accept(frameOf(0.0, {from}));
    flux.accept(frameOf(0.01, {to}));
    return at(tableOf(flux, "line_1"), "flux", 0);
  };
  EXPECT_NEAR(through({0.03, 0.02}, {0.01, 0.03}), one, 1e-9 * one);   // to its left
  EXPECT_NEAR(through({0.01, 0.02}, {0.03, 0.03}), -one, 1e-9 * one);  // to its right
  EXPECT_EQ(through({0.01, 0.06}, {0.03, 0.06}), 0.0);                 // above its end
  EXPECT_EQ(through({0.01, 0.02}, {0.015, 0.04}), 0.0);                // beside it
}

TEST(LineFlux, PartsOfALineGiveTheWhole) {
  const Scene scene = syntheticScene(false, false, 300);
  const AnalysisInput input{scene, 10, 0.01};
  LineFlux whole(input, {{0.024, 0.0}, {0.024, 0.12}}, "w"), low(input, {{0.024, 0.0}, {0.024, 0.04}}, "l"),
      high(input, {{0.024, 0.04}, {0.024, 0.12}}, "h");
  for (int i = 0; i < 10; ++i)
    for (LineFlux* flux : {&whole, &low, &high}) flux->accept(syntheticFrame(scene, i));
  for (const std::size_t k : {0u, 1u, 2u})
    EXPECT_NEAR(0.12 * *whole.findings()[k].value,
                0.04 * *low.findings()[k].value + 0.08 * *high.findings()[k].value, 1e-9);
}

}  // namespace
}  // namespace bedmix::test
