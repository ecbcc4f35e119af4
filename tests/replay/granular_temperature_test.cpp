// SPDX-License-Identifier: MIT
#include "replay/analysis/granular_temperature.h"

#include "replay/analysis/mechanisms.h"
#include "tests/replay/analysis_frames.h"

#include <gtest/gtest.h>

#include <functional>

namespace bedmix::test {
namespace {

Frame moving(double time, const std::function<Vec2(Vec2)>& velocity) {
  const std::vector<Vec2> places = lattice(0.048, 0.12, 0.004);
  Frame frame = frameOf(time, places);
  for (std::size_t i = 0; i < places.size(); ++i) frame.velocity[i] = toFloat(velocity(places[i]));
  return frame;
}

TEST(GranularTemperature, IsNoneOfWhatMovesAlike) {
  const Scene scene = syntheticScene(false, false);
  GranularTemperature analysis({scene, 1, 0.0});
  analysis.accept(moving(0.0, [](Vec2) { return Vec2{0.5, -2.0}; }));
  EXPECT_NEAR(found(analysis, "granular_temperature"), 0.0, 1e-9);
}

TEST(GranularTemperature, OfRandomVelocitiesIsTheirVariance) {
  const Scene scene = syntheticScene(false, false);
  GranularTemperature analysis({scene, 50, 0.01});
  Rng rng(17);
  for (int i = 0; i < 50; ++i)
    analysis.accept(moving(0.01 * i, [&](Vec2) {
      return Vec2{rng.uniform(-0.3, 0.3), rng.uniform(-0.6, 0.6)};
    }));
  const Table table = tableOf(analysis, "temperature");
  const double left = 59.0 / 60.0;  // of the variance of 60 about their own mean
  EXPECT_NEAR(*meanOf(*table.find("temperature_x")), left * 0.03, 3e-4);
  EXPECT_NEAR(*meanOf(*table.find("temperature_y")), left * 0.12, 12e-4);
  EXPECT_NEAR(found(analysis, "granular_temperature"), left * 0.075, 6e-4);
}

TEST(GranularTemperature, CountsTheGradientWithinCells) {
  // u = g y on ten layers a cell: g^2 d^2 (10^2 - 1)/12 along x, half of it the temperature; what mechanisms
  // call shear.
  const Scene scene = syntheticScene(false, false);
  const double g = 5.0, squared = g * g * 0.004 * 0.004 * 99.0 / 12.0;
  GranularTemperature analysis({scene, 1, 0.0});
  const Frame first = moving(0.0, [&](Vec2 at) { return Vec2{g * at.y, 0.0}; });
  analysis.accept(first);
  EXPECT_NEAR(found(analysis, "granular_temperature"), squared / 2.0, 1e-6);

  Mechanisms split({scene, 2, 0.01});
  split.accept(first);
  Frame second = first;
  second.time = 0.01;
  for (std::size_t i = 0; i < second.size(); ++i) second.position[i] += 0.01f * second.velocity[i];
  split.accept(second);
  EXPECT_NEAR(at(tableOf(split, "mechanisms"), "shear", 0), squared, 1e-6);
}

}  // namespace
}  // namespace bedmix::test
