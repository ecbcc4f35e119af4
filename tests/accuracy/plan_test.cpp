// SPDX-License-Identifier: MIT
#include "app/accuracy/plan.h"

#include <gtest/gtest.h>

#include <limits>

namespace bedmix {
namespace {

Design twoPresetsAndOther() {
  Design design;
  design.presets = {"a", "b"};
  design.statistics = {"a", "b", "c"};
  return design;
}

const std::map<std::string, double> costs{{"a", 1.0}, {"b", 2.0}, {"c", 3.0}};  // wall s per simulated s

double wall(const StatisticsPlan& plan, int cores) {
  return (3.0 * plan.presetSeeds + 3.0 * plan.otherSeeds) * plan.duration / cores;
}

TEST(Plan, WithoutABudgetDropsNothing) {
  const auto plan =
      planStatistics(twoPresetsAndOther(), costs, 10.0, 0.01, std::numeric_limits<double>::infinity(), 4, 8);
  EXPECT_TRUE(plan.dropped.empty());
  EXPECT_EQ(plan.duration, 10.0);
  EXPECT_GT(plan.presetSeeds, plan.otherSeeds);
  Design withPaper = twoPresetsAndOther();
  withPaper.paper = "b";
  EXPECT_EQ(plan.seeds(withPaper, "a"), 8);
  EXPECT_EQ(plan.seeds(withPaper, "b"), 4);
}

TEST(Plan, KeepsTheBudgetAndSaysWhatItDropped) {
  std::size_t before = 0;
  for (const double budget : {150.0, 100.0, 80.0, 60.0, 40.0, 20.0}) {
    const auto plan = planStatistics(twoPresetsAndOther(), costs, 10.0, 0.01, budget, 4, 8);
    EXPECT_LE(wall(plan, 4), budget);
    EXPECT_GE(plan.dropped.size(), before) << budget;
    before = plan.dropped.size();
    EXPECT_GE(plan.presetSeeds, 3);  // or no interval could be given
  }
  EXPECT_EQ(before, 3u);
}

TEST(Plan, TakesAsManyRunsOfPresetsAsAreAskedFor) {
  const double endless = std::numeric_limits<double>::infinity();
  const auto many = planStatistics(twoPresetsAndOther(), costs, 10.0, 0.01, endless, 4, 100);
  EXPECT_EQ(many.presetSeeds, 100);
  EXPECT_EQ(many.otherSeeds, 4);
  const auto few = planStatistics(twoPresetsAndOther(), costs, 10.0, 0.01, endless, 4, 2);
  EXPECT_EQ(few.presetSeeds, 2);
  EXPECT_EQ(few.otherSeeds, 2);
  EXPECT_TRUE(few.dropped.empty());
}

TEST(Plan, SettingsGoBeforeRunsOfPresetsAndThoseBeforeTheirLength) {
  const auto presets = planStatistics(twoPresetsAndOther(), costs, 10.0, 0.01, 80.0, 4, 8);
  EXPECT_EQ(presets.otherSeeds, 0);
  EXPECT_EQ(presets.seeds(twoPresetsAndOther(), "c"), 0);
  EXPECT_EQ(presets.seeds(twoPresetsAndOther(), "a"), 8);
  const auto fewer = planStatistics(twoPresetsAndOther(), costs, 10.0, 0.01, 50.0, 4, 8);
  EXPECT_LT(fewer.presetSeeds, 8);
  EXPECT_EQ(fewer.duration, 10.0);
  const auto shorter = planStatistics(twoPresetsAndOther(), costs, 10.0, 0.01, 20.0, 4, 8);
  EXPECT_EQ(shorter.presetSeeds, 4);
  EXPECT_LT(shorter.duration, 10.0);
}

}  // namespace
}  // namespace bedmix
