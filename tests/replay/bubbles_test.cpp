// SPDX-License-Identifier: MIT
#include "replay/analysis/bubbles.h"

#include "tests/replay/analysis_frames.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bedmix::test {
namespace {

struct Disc {
  Vec2 centre;
  double radius;
};

/// A bed 48 mm wide and 100 mm high on gas cells of 2 mm, with discs of gas in it and nothing above.
class DiscsOfGas : public testing::Test {
 protected:
  DiscsOfGas() : scene(syntheticScene(true, false)) {
    scene.gas->grid = {{{24, 0.002}}, {{60, 0.002}}};
    grid = makeGasGrid(scene);
  }
  Frame frame(double time, const std::vector<Disc>& discs) const {
    Frame f = frameOf(time, lattice(0.048, 0.1, 0.004));
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        const Vec2 at{0.002 * (column + 0.5), 0.002 * (row + 0.5)};
        bool empty = at.y > 0.1;
        for (const Disc& d : discs) empty = empty || norm(at - d.centre) < d.radius;
        f.gas.voidage.push_back(empty ? 0.95f : 0.45f);
        f.gas.pressure.push_back(0.0f);
        f.gas.velocity.push_back({});
      }
    return f;
  }

  Scene scene;
  GasGrid grid;
};

TEST_F(DiscsOfGas, HaveTheirSizeAndSpeed) {
  Bubbles analysis({scene, 11, 0.01});
  for (int i = 0; i <= 10; ++i)  // 0.4 m/s up, two cells a frame
    analysis.accept(frame(0.01 * i, {{{0.024, 0.03 + 0.004 * i}, 0.008}}));
  EXPECT_EQ(found(analysis, "bubbles"), 1.0);
  EXPECT_NEAR(found(analysis, "bubble_diameter"), 0.016, 0.0004);
  EXPECT_NEAR(found(analysis, "bubble_rise"), 0.4, 1e-9);
  EXPECT_NEAR(found(analysis, "bubble_frequency"), 1.0 / 0.1, 1e-9);
  const Table table = tableOf(analysis, "bubbles");
  ASSERT_EQ(table.rows(), 11u);
  EXPECT_TRUE(std::isnan(at(table, "rise", 0)));
  EXPECT_NEAR(at(table, "x", 5), 0.024, 1e-9);
  EXPECT_NEAR(at(table, "y", 5), 0.05, 1e-9);
  // The profile has it at the stretch of 12 mm around 54 mm for three frames: 50, 54, 58 mm.
  EXPECT_NEAR(at(tableOf(analysis, "bubble_profile"), "bubbles", 4), 3.0 / 11.0, 1e-9);
}

// One that the seam goes through is one, wherever it goes.
TEST_F(DiscsOfGas, GoOnBeyondPeriodicSides) {
  scene.bed.sides = BedSides::periodic;
  Bubbles analysis({scene, 11, 0.01});
  for (int i = 0; i <= 10; ++i) {
    const double x = 0.044 + 0.0008 * i, y = 0.03 + 0.004 * i;
    analysis.accept(frame(0.01 * i, {{{x, y}, 0.008}, {{x - 0.048, y}, 0.008}}));
  }
  EXPECT_EQ(found(analysis, "bubbles"), 1.0);
  EXPECT_NEAR(found(analysis, "bubble_diameter"), 0.016, 0.0004);
  EXPECT_NEAR(found(analysis, "bubble_rise"), 0.4, 1e-9);
  const Table table = tableOf(analysis, "bubbles");
  ASSERT_EQ(table.rows(), 11u);
  for (std::size_t r = 0; r < table.rows(); ++r) {
    const double x = 0.044 + 0.0008 * static_cast<double>(r);
    EXPECT_NEAR(std::remainder(at(table, "x", r) - x, 0.048), 0.0, 0.001);
  }
}

TEST_F(DiscsOfGas, StandBesideTheCorrelations) {
  Bubbles analysis({scene, 1, 0.01});
  analysis.accept(frame(0.0, {{{0.024, 0.05}, 0.008}}));
  const double excess = inletVelocity(scene, scene.gas->inlets[0]) - minimumFluidizationVelocity(scene);
  EXPECT_NEAR(found(analysis, "bubble_diameter_darton"),
              0.54 * std::pow(excess, 0.4) * std::pow(0.05, 0.8) / std::pow(9.81, 0.2), 1e-5);
  EXPECT_NEAR(found(analysis, "bubble_rise_davidson"),
              excess + 0.711 * std::sqrt(9.81 * found(analysis, "bubble_diameter")), 1e-9);
}

TEST_F(DiscsOfGas, AreNoBubblesOnceTheyAreOpen) {
  Bubbles analysis({scene, 2, 0.01});
  analysis.accept(frame(0.0, {{{0.024, 0.096}, 0.008}, {{0.01, 0.03}, 0.006}}));
  EXPECT_EQ(found(analysis, "bubbles"), 1.0);
  EXPECT_NEAR(at(tableOf(analysis, "bubbles"), "y", 0), 0.03, 1e-9);
}

TEST_F(DiscsOfGas, AreFollowedThroughMergers) {
  // The larger of two that merge lives on.
  Bubbles analysis({scene, 2, 0.01});
  analysis.accept(frame(0.0, {{{0.014, 0.04}, 0.008}, {{0.03, 0.04}, 0.005}}));
  analysis.accept(frame(0.01, {{{0.014, 0.04}, 0.008}, {{0.022, 0.04}, 0.006}, {{0.03, 0.04}, 0.005}}));
  const Table table = tableOf(analysis, "bubbles");
  ASSERT_EQ(table.rows(), 3u);
  EXPECT_NEAR(at(table, "rise", 2), 0.0, 1e-9);
}

TEST_F(DiscsOfGas, CountFromTheScenesVoidageOn) {
  scene.pictures.emplace().bubbleVoidage = 0.96;
  Bubbles analysis({scene, 1, 0.01});
  analysis.accept(frame(0.0, {{{0.024, 0.05}, 0.008}}));
  EXPECT_EQ(found(analysis, "bubbles"), 0.0);
  EXPECT_TRUE(std::isnan(found(analysis, "bubble_diameter")));
}

}  // namespace
}  // namespace bedmix::test
