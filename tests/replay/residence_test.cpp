// SPDX-License-Identifier: MIT
#include "replay/analysis/residence.h"

#include "tests/replay/analysis_frames.h"

#include <gtest/gtest.h>

namespace bedmix::test {
namespace {

/// Two crowds that change places: each is low for `low` frames, then high as long, the other the other way
/// round.
std::vector<Vec2> crowds(int frame, int low, double shake) {
  std::vector<Vec2> places;
  for (int p = 0; p < 20; ++p) {
    const bool isLow = (frame / low % 2 == 0) == (p < 10);
    places.push_back({0.01 + 0.001 * p, (isLow ? 0.008 : 0.06) + shake * ((frame + p) % 2)});
  }
  return places;
}

TEST(Residence, FindsThePeriodsOfARegularMotion) {
  const Scene scene = syntheticScene(false, false);
  Residence analysis({scene, 81, 0.01});
  for (int i = 0; i <= 80; ++i) analysis.accept(frameOf(0.01 * i, crowds(i, 4, 0.003)));
  EXPECT_NEAR(found(analysis, "residence_lower"), 0.04, 1e-12);
  EXPECT_NEAR(found(analysis, "residence_upper"), 0.04, 1e-12);
  EXPECT_NEAR(found(analysis, "residence_near_distributor"), 0.04, 1e-12);
  EXPECT_NEAR(found(analysis, "return_to_distributor"), 0.04, 1e-12);
  EXPECT_NEAR(found(analysis, "cycle_time"), 0.08, 1e-12);

  const Table table = tableOf(analysis, "residence");
  double stays = 0.0, cycles = 0.0;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    const bool halves = at(table, "from", r) <= 0.04 && 0.04 < at(table, "to", r);
    const bool whole = at(table, "from", r) <= 0.08 && 0.08 < at(table, "to", r);
    stays += at(table, "lower", r);
    cycles += at(table, "cycle", r);
    EXPECT_TRUE(halves || at(table, "lower", r) == 0.0);
    EXPECT_TRUE(whole || at(table, "cycle", r) == 0.0);
  }
  EXPECT_EQ(stays,
            10.0 * 9.0 + 10.0 * 10.0);  // that of the start is not whole for the crowd that is low then
  EXPECT_EQ(cycles, 20.0 * 9.0);
}

TEST(Residence, DoesNotCountTremblingAtTheBorder) {
  // Ten particles at the floor, ten that shake by less than a diameter about the middle, ten far above.
  const Scene scene = syntheticScene(false, false);
  Residence analysis({scene, 20, 0.01});
  for (int i = 0; i < 20; ++i) {
    std::vector<Vec2> places;
    for (int p = 0; p < 30; ++p)
      places.push_back({0.024, 0.04 * (p / 10) + (p / 10 == 1 ? 0.003 * ((i + p) % 2) : 0.0)});
    analysis.accept(frameOf(0.01 * i, places));
  }
  EXPECT_TRUE(std::isnan(found(analysis, "cycle_time")));
  EXPECT_TRUE(std::isnan(found(analysis, "residence_lower")));
}

TEST(Residence, TakesParticlesThatComeAndGo) {
  const Scene scene = syntheticScene(false, false);
  Residence analysis({scene, 30, 0.01});
  for (int i = 0; i < 30; ++i) analysis.accept(without(syntheticFrame(scene, i), 2 + i % 4));
  EXPECT_GT(found(analysis, "cycle_time"), 0.0);
  Residence none({scene, 1, 0.0});
  none.accept(frameOf(0.0, {}));
  EXPECT_TRUE(std::isnan(found(none, "cycle_time")));
}

}  // namespace
}  // namespace bedmix::test
