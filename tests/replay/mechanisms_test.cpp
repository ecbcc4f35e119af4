// SPDX-License-Identifier: MIT
#include "replay/analysis/mechanisms.h"

#include "tests/replay/analysis_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace bedmix::test {
namespace {

/// A bed of `columns` x `rows` sampling cells.
Scene bedOf(int columns, int rows) {
  Scene scene = syntheticScene(false, false);
  scene.sampling = {columns, rows, 5, 0.01};
  return scene;
}

/// After one step of 0.01 s of a full bed, each particle by what `move` says of its place.
Mechanisms afterStep(const Scene& scene, const std::function<Vec2(Vec2)>& move) {
  Mechanisms analysis({scene, 2, 0.01});
  std::vector<Vec2> places = lattice(scene.bed.width, scene.bed.height, 0.004);
  analysis.accept(frameOf(0.0, places));
  for (Vec2& place : places) place += move(place);
  analysis.accept(frameOf(0.01, places));
  return analysis;
}

TEST(Mechanisms, TranslationIsConvective) {
  const Scene scene = bedOf(2, 3);
  const Mechanisms analysis = afterStep(scene, [](Vec2) { return Vec2{0.001, -0.002}; });
  EXPECT_NEAR(found(analysis, "motion_convective"), 1.0, 1e-6);
  EXPECT_NEAR(at(tableOf(analysis, "mechanisms"), "total", 0), 0.05, 1e-6);  // (0.1^2 + 0.2^2) m2/s2
  EXPECT_EQ(at(tableOf(analysis, "mechanisms"), "counted_fraction", 0), 1.0);
}

TEST(Mechanisms, RotationAndSimpleShearAboutTheMiddleOfACellAreShear) {
  const Scene scene = bedOf(1, 1);
  const Vec2 middle{scene.bed.width / 2, scene.bed.height / 2};
  const Mechanisms turned = afterStep(scene, [&](Vec2 at) {
    return 0.05 * Vec2{-(at - middle).y, (at - middle).x};
  });
  EXPECT_NEAR(found(turned, "motion_shear"), 1.0, 1e-6);
  const Mechanisms sheared = afterStep(scene, [&](Vec2 at) { return Vec2{0.05 * (at - middle).y, 0.0}; });
  EXPECT_NEAR(found(sheared, "motion_shear"), 1.0, 1e-6);
}

TEST(Mechanisms, ShearAcrossCellsIsConvectiveBetweenThemAndShearWithin) {
  // u = g (y - H/2) over three cells: their means are at -H/3, 0, H/3; 10 layers of d in each.
  const Scene scene = bedOf(1, 3);
  const double g = 0.05, d = 0.004, between = 2.0 / 3.0 * 0.04 * 0.04, within = (100.0 - 1.0) / 12.0 * d * d;
  const Mechanisms analysis = afterStep(scene, [&](Vec2 at) { return Vec2{g * (at.y - 0.06), 0.0}; });
  const Table table = tableOf(analysis, "mechanisms");
  EXPECT_NEAR(at(table, "convective", 0), g * g * between / 1e-4, 1e-6);
  EXPECT_NEAR(at(table, "shear", 0), g * g * within / 1e-4, 1e-6);
  EXPECT_NEAR(at(table, "diffusive", 0), 0.0, 1e-9);
}

TEST(Mechanisms, RandomMotionIsDiffusiveButForWhatAFitTakes) {
  // Three parameters fitted to n independent displacements: 1/n passes for convection, 2/n for shear.
  const Scene scene = bedOf(2, 3);
  Rng rng(5);
  Mechanisms analysis({scene, 200, 0.01});
  const std::vector<Vec2> home = lattice(0.048, 0.12, 0.004);  // 60 a cell
  double time = 0.0;
  for (int pair = 0; pair < 100; ++pair) {
    std::vector<Vec2> places = home;
    analysis.accept(frameOf(time, places));
    for (Vec2& place : places) place += Vec2{rng.uniform(-1e-3, 1e-3), rng.uniform(-1e-3, 1e-3)};
    analysis.accept(frameOf(time + 0.01, places));
    time += 0.02;
  }
  EXPECT_NEAR(found(analysis, "motion_convective"), 1.0 / 60.0, 0.003);
  EXPECT_NEAR(found(analysis, "motion_shear"), 2.0 / 60.0, 0.004);
  EXPECT_NEAR(found(analysis, "motion_diffusive"), 57.0 / 60.0, 0.005);
}

TEST(Mechanisms, PartsAddUpToTheWholeAsParticlesComeAndGo) {
  Scene scene = bedOf(2, 3);
  scene.particles.count = 600;
  Mechanisms analysis({scene, 40, 0.01});
  for (int i = 0; i < 40; ++i) analysis.accept(without(syntheticFrame(scene, i), 2 + i % 5));
  const Table steps = tableOf(analysis, "mechanisms");
  ASSERT_EQ(steps.rows(), 39u);
  for (std::size_t r = 0; r < steps.rows(); ++r) {
    const double total = at(steps, "total", r);
    EXPECT_NEAR(at(steps, "convective", r) + at(steps, "shear", r) + at(steps, "diffusive", r), total,
                1e-12 * total);
  }
  const Table lags = tableOf(analysis, "mechanisms_lag");
  ASSERT_EQ(lags.rows(), 4u);  // 1, 2, 4, 8 frames
  for (std::size_t r = 0; r < lags.rows(); ++r) {
    EXPECT_NEAR(at(lags, "lag", r), 0.01 * (1 << r), 1e-12);
    for (const std::string axis : {"_x", "_y"}) {
      const double msd = at(lags, "msd" + axis, r);
      EXPECT_NEAR(at(lags, "convective" + axis, r) + at(lags, "shear" + axis, r) +
                      at(lags, "diffusive" + axis, r) + at(lags, "dilute" + axis, r),
                  msd, 1e-12 * msd);
    }
  }
}

TEST(Mechanisms, WhatDoesNotLastDoesNotMix) {
  // Particles shake about places that drift 0.1 mm a frame: most of the motion is on their own, and none of
  // where they get to.
  const Scene scene = bedOf(1, 1);
  Rng rng(7);
  Mechanisms analysis({scene, 257, 0.01});
  const std::vector<Vec2> home = lattice(0.02, 0.12, 0.002);
  for (int i = 0; i < 257; ++i) {
    std::vector<Vec2> places = home;
    for (Vec2& place : places) place += Vec2{1e-4 * i + rng.uniform(-1e-3, 1e-3), rng.uniform(-1e-3, 1e-3)};
    for (Vec2& place : places) place.x = std::max(place.x, 0.0);
    analysis.accept(frameOf(0.01 * i, places));
  }
  EXPECT_GT(found(analysis, "motion_diffusive"), 0.95);
  EXPECT_NEAR(found(analysis, "mixing_lag"), 0.64, 1e-9);
  // (64 x 0.1 mm)^2 of drift beside twice the variance of the shaking
  EXPECT_NEAR(found(analysis, "mixing_convective_x"), 40.96 / (40.96 + 2.0 / 3.0), 0.01);
}

TEST(Mechanisms, CellsWithTooFewAreNotSplit) {
  Scene scene = bedOf(1, 1);
  scene.sampling.minParticles = 3;
  Mechanisms analysis({scene, 9, 0.01});
  for (int i = 0; i < 9; ++i) analysis.accept(frameOf(0.01 * i, {{0.01, 0.01 + 0.001 * i}, {0.02, 0.01}}));
  EXPECT_TRUE(std::isnan(found(analysis, "motion_convective")));
  EXPECT_NEAR(found(analysis, "mixing_dilute_y"), 1.0, 1e-12);
}

TEST(Mechanisms, TakesWhateverFramesThereAre) {
  const Scene scene = bedOf(2, 3);
  Mechanisms analysis({scene, 8, 0.01});
  EXPECT_EQ(analysis.tables().front().table.rows(), 0u);
  for (int i = 0; i < 8; ++i) analysis.accept(frameOf(0.01 * i, {}));
  EXPECT_TRUE(std::isnan(found(analysis, "mixing_lag")));
}

}  // namespace
}  // namespace bedmix::test
