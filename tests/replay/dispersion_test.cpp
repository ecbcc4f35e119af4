// SPDX-License-Identifier: MIT
#include "replay/analysis/dispersion.h"

#include "tests/replay/analysis_frames.h"

#include <gtest/gtest.h>

namespace bedmix::test {
namespace {

TEST(Dispersion, FindsTheCoefficientsOfARandomWalk) {
  // Steps uniform in (-a, a): D = a^2/(6 dt). The bed as a whole is shaken, and a few particles leave.
  const Scene scene = syntheticScene(false, false);
  const double a = 0.002, b = 0.001, dt = 0.01;
  Rng rng(11);
  Dispersion analysis({scene, 400, dt});
  std::vector<Vec2> places(4000);
  for (int i = 0; i < 400; ++i) {
    Frame frame = frameOf(dt * i, places);
    for (Vec2f& at : frame.position) at += Vec2f{0.0f, 0.05f * static_cast<float>(i % 3)};
    analysis.accept(i > 200 ? without(frame, 50) : frame);
    for (Vec2& at : places) at += Vec2{rng.uniform(-a, a), rng.uniform(-b, b)};
  }
  EXPECT_NEAR(found(analysis, "dispersion_x") / (a * a / (6.0 * dt)), 1.0, 0.04);
  EXPECT_NEAR(found(analysis, "dispersion_y") / (b * b / (6.0 * dt)), 1.0, 0.04);
  // The fit ends where msd = 2 D t reaches a quarter of the width: 144 mm2.
  EXPECT_NEAR(found(analysis, "dispersion_x_until"), 0.012 * 0.012 / (2.0 * a * a / (6.0 * dt)), 0.06);
}

TEST(Dispersion, OfFlightsGrowsWithTheSquareOfTheLag) {
  const Scene scene = syntheticScene(false, false);
  Dispersion analysis({scene, 40, 0.01});
  for (int i = 0; i < 40; ++i) {
    std::vector<Vec2> places;
    for (int p = 0; p < 100; ++p) places.push_back({0.02 + (p % 2 ? 5e-4 : -5e-4) * i, 0.01 + 1e-3 * i});
    analysis.accept(frameOf(0.01 * i, places));
  }
  const Table table = tableOf(analysis, "dispersion");
  ASSERT_EQ(table.rows(), 20u);
  for (std::size_t r = 0; r < table.rows(); ++r) {
    const double lag = at(table, "lag", r), msd = 0.05 * 0.05 * lag * lag * 100.0 / 99.0;
    EXPECT_NEAR(at(table, "msd_x", r), msd, 1e-4 * msd);
    EXPECT_NEAR(at(table, "msd_y", r), 0.0, 1e-12);  // all move alike
  }
}

// Who goes around and around between periodic sides gets ever further.
TEST(Dispersion, GoesOnAroundPeriodicSides) {
  Scene scene = syntheticScene(false, false);
  scene.bed.sides = BedSides::periodic;
  Dispersion analysis({scene, 40, 0.01});
  for (int i = 0; i < 40; ++i) {
    std::vector<Vec2> places;
    for (int p = 0; p < 100; ++p) {
      const double x = 0.01 + (p % 2 ? 8e-3 : -8e-3) * i;
      places.push_back({x - 0.048 * std::floor(x / 0.048), 0.01});
    }
    analysis.accept(frameOf(0.01 * i, places));
  }
  const Table table = tableOf(analysis, "dispersion");
  ASSERT_EQ(table.rows(), 20u);  // the last of them after three rounds
  for (std::size_t r = 0; r < table.rows(); ++r) {
    const double lag = at(table, "lag", r), msd = 0.8 * 0.8 * lag * lag * 100.0 / 99.0;
    EXPECT_NEAR(at(table, "msd_x", r), msd, 1e-4 * msd);
  }
}

TEST(Dispersion, OfNothingIsNotDefined) {
  const Scene scene = syntheticScene(false, false);
  Dispersion analysis({scene, 1, 0.0});
  analysis.accept(syntheticFrame(scene, 0));
  EXPECT_TRUE(std::isnan(found(analysis, "dispersion_x")));
  EXPECT_EQ(tableOf(analysis, "dispersion").rows(), 0u);
}

}  // namespace
}  // namespace bedmix::test
