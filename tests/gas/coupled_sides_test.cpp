// SPDX-License-Identifier: MIT
#include "engine/checkpoint.h"
#include "engine/coupling/exchange.h"
#include "engine/coupling/voidage.h"
#include "engine/dem/particles.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bedmix {
namespace {

constexpr double width = 0.096;  // m

/// A low bed between periodic sides that a jet blows through, all of it `columns` gas cells to the right.
Scene periodicScene(int columns) {
  Scene scene = test::paperScene(0.0);
  scene.bed.sides = BedSides::periodic;
  scene.particles.count = 240;
  scene.effects.at<HeatSettings>() = HeatSettings{
      .heatCapacity = 0.5, .conductivity = 200.0, .temperature = 350.0, .gas = HeatGasSettings{}};
  scene.gas->inlets.clear();
  for (const int column : {3, 4}) {
    const double from = ((column + columns) % 8) * 0.012;
    scene.gas->inlets.push_back({from, from + 0.012, 4.0, std::nullopt});
  }
  return scene;
}

Simulation shifted(const Scene& scene, int columns) {
  std::vector<Vec2> places;
  for (int i = 0; i < 240; ++i) {
    const double x = (0.5 + i % 20) * 0.0048 + 4e-4 * std::sin(1.7 * i), y = 0.0022 + 0.0043 * (i / 20);
    places.push_back({x + columns * 0.012 - width * std::floor((x + columns * 0.012) / width), y});
  }
  return Simulation::make(scene, makeParticles(scene, places));
}

// Nothing tells gas and particles where the seam is, until rounding has grown.
TEST(CoupledSides, BedGoesWithItsInlets) {
  Simulation here = shifted(periodicScene(0), 0), there = shifted(periodicScene(4), 4);
  ASSERT_EQ(here.advance(4000), std::nullopt);
  ASSERT_EQ(there.advance(4000), std::nullopt);
  EXPECT_GT(here.contacts(), 50);
  EXPECT_EQ(here.contacts(), there.contacts());
  EXPECT_LT(here.report().largestMassResidual, 1e-10);
  EXPECT_LT(there.report().largestMassResidual, 1e-10);
  const FramePtr a = here.frame(), b = there.frame();
  double moved = 0.0;
  float coldest = 350.0f;
  for (std::size_t i = 0; i < a->size(); ++i) {
    const double apart = static_cast<double>(b->position[i].x) - static_cast<double>(a->position[i].x);
    EXPECT_NEAR(std::remainder(apart - 0.048, width), 0.0, 1e-7) << i;
    EXPECT_NEAR(b->position[i].y, a->position[i].y, 1e-7) << i;
    EXPECT_NEAR(b->velocity[i].x, a->velocity[i].x, 1e-5) << i;
    EXPECT_NEAR(b->temperature[i], a->temperature[i], 1e-3) << i;
    coldest = std::min(coldest, a->temperature[i]);
    moved = std::max(moved, static_cast<double>(std::abs(a->velocity[i].x)));
  }
  EXPECT_GT(moved, 0.05);
  EXPECT_LT(coldest, 345.0f);
  for (int row = 0; row < 27; ++row)
    for (int column = 0; column < 8; ++column) {
      const int from = row * 8 + column, to = row * 8 + (column + 4) % 8;
      EXPECT_NEAR(b->gas.voidage[to], a->gas.voidage[from], 1e-6);
      EXPECT_NEAR(b->gas.velocity[to].x, a->gas.velocity[from].x, 1e-5);
      EXPECT_NEAR(b->gas.temperature[to], a->gas.temperature[from], 1e-3);
      EXPECT_NEAR(b->gas.pressure[to], a->gas.pressure[from], 1e-3);
    }
}

// All particles' volume is in the cells, those over the seam on both of its sides.
TEST(CoupledSides, VoidageHoldsAllParticles) {
  Scene scene = periodicScene(0);
  scene.bed.top = BedTop::lid;  // no taper
  const GasGrid grid = makeGasGrid(scene);
  ThreadTeam team(2);
  VoidageField field(scene, grid, team);
  const std::vector<Vec2> places{{0.0005, 0.05}, {0.0955, 0.05}, {0.04, 0.1}, {0.0, 0.19}, {0.096, 0.3}};
  field.update(places);
  double solids = 0.0;
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i)
      solids += (1.0 - field.voidage()[grid.cell(i, j)]) * grid.volume(i, j);
  EXPECT_NEAR(solids / (5.0 * particleVolume(scene)), 1.0, 1e-12);
  // Half of one that sits on the seam is on either side.
  const auto solidsIn = [&](int i, int j) {
    return (1.0 - field.voidage()[grid.cell(i, j)]) * grid.volume(i, j);
  };
  const int row = 15;  // of y = 0.19
  EXPECT_NEAR(solidsIn(0, row) / particleVolume(scene), 0.5, 1e-9);
  EXPECT_NEAR(solidsIn(7, row) / particleVolume(scene), 0.5, 1e-9);
}

// What particles at the seam give goes to faces that are solved for, none of it to ghosts.
TEST(CoupledSides, GasGetsAllThatParticlesGive) {
  Scene scene = periodicScene(0);
  scene.bed.top = BedTop::lid;  // no taper
  ThreadTeam team(2);
  GasSolver gas(scene, team);
  VoidageField voidage(scene, gas.grid(), team);
  Exchange exchange(scene, gas, voidage, team);
  Particles p =
      makeParticles(scene, {{0.0005, 0.05}, {0.0955, 0.05}, {0.0021, 0.1}, {0.0, 0.19}, {0.095, 0.3}});
  p.velocity = {{0.3, 0.1}, {-0.2, 0.4}, {0.5, -0.6}, {-0.7, 0.2}, {0.9, 0.3}};
  p.addExternalForces();
  voidage.update(p.position);
  exchange.evaluateDrag(p, gas.exchange());
  const FaceLayout& layout = gas.layout();
  double coefficient = 0.0, given = 0.0;
  Vec2 got, momentum;
  for (std::size_t i = 0; i < p.size(); ++i) {
    given += p.drag[i];
    momentum += p.drag[i] * p.velocity[i];
  }
  for (const MomentumVolume& v : layout.volumes) {
    (v.vertical ? got.y : got.x) += gas.exchange().source[v.face];
    if (!v.vertical) coefficient += gas.exchange().coefficient[v.face];
  }
  EXPECT_GT(given, 0.0);
  EXPECT_NEAR(coefficient / given, 1.0, 1e-12);
  EXPECT_NEAR(got.x / momentum.x, 1.0, 1e-12);
  EXPECT_NEAR(got.y / momentum.y, 1.0, 1e-12);
}

TEST(DeterminismOfSides, ThreadsAndResume) {
  const Scene scene = periodicScene(2);
  Simulation whole = shifted(scene, 2);
  ASSERT_EQ(whole.advance(3000), std::nullopt);
  const std::vector<std::byte> bytes = writeCheckpoint(whole, scene, 0.0);
  auto resumed = readCheckpoint(bytes, scene, 3);
  ASSERT_TRUE(resumed) << resumed.problems.front().message;
  EXPECT_EQ(resumed->simulation.stateHash(), whole.stateHash());
  ASSERT_EQ(whole.advance(3000), std::nullopt);
  ASSERT_EQ(resumed->simulation.advance(3000), std::nullopt);
  EXPECT_EQ(resumed->simulation.stateHash(), whole.stateHash());
  EXPECT_EQ(resumed->simulation.frame()->position, whole.frame()->position);
}

}  // namespace
}  // namespace bedmix
