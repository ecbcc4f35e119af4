// SPDX-License-Identifier: MIT
#include "engine/core/period.h"

#include "engine/core/sampling_grid.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

Period periodOf(double width) {
  Scene scene;
  scene.bed.width = width;
  scene.bed.sides = BedSides::periodic;
  return Period(scene);
}

TEST(Period, WallsHaveNone) {
  const Period none{Scene{}};
  EXPECT_FALSE(none.isOn());
  EXPECT_EQ(none.nearest({0.09, 0.1}), (Vec2{0.09, 0.1}));
  EXPECT_EQ(none.rounded({-0.01, 0.2}), (Vec2f{-0.01f, 0.2f}));
}

TEST(Period, TakesTheShorterWay) {
  const Period period = periodOf(0.1);
  EXPECT_NEAR(period.nearest({0.09, 0.3}).x, -0.01, 1e-15);
  EXPECT_NEAR(period.nearest({-0.09, 0.3}).x, 0.01, 1e-15);
  EXPECT_EQ(period.nearest({0.04, 0.3}), (Vec2{0.04, 0.3}));
  EXPECT_NEAR(period.next({0.099f, 0.0f}, {0.002f, 0.0f}).x, 0.102f, 1e-7f);
}

// Whoever hangs over by next to nothing is in the bed, and in a sampling cell, too.
TEST(Period, RoundingLeavesNobodyOutside) {
  for (const double width : {0.096, 0.1, 0.15, 1.0 / 3.0, 7.3}) {
    const Period period = periodOf(width);
    for (const double x : {0.0, -1e-20, -1e-17, width, std::nextafter(width, 0.0), std::nextafter(width, 8.0),
                           width - 1e-12, 1.5 * width, -0.5 * width}) {
      double at = x;
      for (int k = 0; k < 3; ++k) at += period.shiftOf(at);
      EXPECT_GE(at, 0.0) << x;
      EXPECT_LE(at, width) << x;
      EXPECT_GE(cellOf(period.rounded({at, 0.0}).x, width, 4), 0) << x;
    }
  }
}

}  // namespace
}  // namespace bedmix
