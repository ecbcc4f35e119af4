// SPDX-License-Identifier: MIT
#include "engine/core/simd.h"
#include "engine/gas/gas_solver.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace bedmix {
namespace {

/// A plane channel without particles, slow enough (Re 0.1) to be developed a width behind its uniform inlet.
Scene channel(int columns, GasScheme scheme, TimeScheme time) {
  Scene scene = test::paperScene(0.1);
  scene.gravity = 0.0;
  scene.bed.width = 0.1;
  scene.bed.height = 0.4;
  scene.gas->density = 1.0;
  scene.gas->viscosity = 0.1;
  scene.gas->step = 2e-3;
  scene.gas->scheme = scheme;
  scene.gas->timeScheme = time;
  scene.gas->grid.columns = {{columns, 0.1 / columns}};
  scene.gas->grid.rows = {{20, 0.02}};
  scene.gas->inlets = {{0.0, 0.1, 0.1, std::nullopt}};
  return scene;
}

struct ChannelResult {
  double profileError;      // root mean square over the mean velocity
  double pressureGradient;  // Pa/m
};

ChannelResult developed(const Scene& scene) {
  ThreadTeam team(1);
  GasSolver gas(scene, team);
  const std::vector<double> empty(gas.grid().cells(), 1.0);
  for (int step = 0; step < 300; ++step) {
    const GasStepReport r = gas.advance(empty);
    EXPECT_TRUE(r.solved && r.converged);
    EXPECT_LT(r.massResidual, 1e-10);
  }
  const GasGrid& grid = gas.grid();
  const double width = scene.bed.width, mean = 0.1;
  const int row = 12;  // 2.4 widths behind the inlet
  double squares = 0.0;
  for (int c = 0; c < grid.columns; ++c) {
    const double x = 0.5 * (grid.x[c] + grid.x[c + 1]) / width;
    const double exact = 6.0 * mean * x * (1.0 - x);
    squares += std::pow(gas.fields().velocity[gas.layout().vFace(c, row)] - exact, 2);
  }
  const double gradient =
      (gas.fields().pressure[grid.cell(0, row - 1)] - gas.fields().pressure[grid.cell(0, row + 1)]) /
      (2 * grid.dy(row));
  return {std::sqrt(squares / grid.columns) / mean, gradient};
}

TEST(Channel, ProfileIsParabolicWithSecondOrderConvergence) {
  double previous = 0.0;
  for (int columns : {8, 16, 32}) {
    const ChannelResult r = developed(channel(columns, GasScheme::projection, TimeScheme::crankNicolson));
    if (previous > 0.0) {
      EXPECT_NEAR(std::log2(previous / r.profileError), 2.0, 0.1);
    }
    previous = r.profileError;
    EXPECT_NEAR(r.pressureGradient, 12 * 0.1 * 0.1 / 0.01, 12.0 * 4.0 / (columns * columns));
  }
  EXPECT_LT(previous, 2e-3);
}

TEST(Channel, EverySchemeFindsTheSameFlow) {
  const double reference =
      developed(channel(16, GasScheme::projection, TimeScheme::crankNicolson)).profileError;
  for (GasScheme scheme : {GasScheme::projection, GasScheme::simple})
    for (TimeScheme time : {TimeScheme::crankNicolson, TimeScheme::implicitEuler})
      EXPECT_NEAR(developed(channel(16, scheme, time)).profileError, reference, 1e-6);
}

TEST(Channel, GasAtRestStaysAtRestUnderItsOwnWeight) {
  Scene scene = test::paperScene(0.0);
  ThreadTeam team(1);
  GasSolver gas(scene, team);
  const std::vector<double> empty(gas.grid().cells(), 1.0);
  for (int step = 0; step < 10; ++step) ASSERT_TRUE(gas.advance(empty).solved);
  for (double u : gas.fields().velocity) EXPECT_NEAR(u, 0.0, 1e-12);
  const double middleOfLowestCell = 0.42 - 0.006;
  EXPECT_NEAR(gas.fields().pressure[gas.grid().cell(3, 0)], 1.205 * 9.81 * middleOfLowestCell, 1e-9);
}

TEST(Channel, StairOfBlockedCellsLeaksNothing) {
  const Scene scene = test::inclinedScene();
  ThreadTeam team(1);
  GasSolver gas(scene, team);
  const std::vector<double> empty(gas.grid().cells(), 1.0);
  for (int step = 0; step < 200; ++step) {
    const GasStepReport r = gas.advance(empty);
    ASSERT_TRUE(r.solved);
    EXPECT_LT(r.massResidual, 1e-10);
  }
  const GasGrid& grid = gas.grid();
  double inflow = 0.0, outflow = 0.0;
  for (const FloorFace& f : gas.layout().floor) inflow += f.flux;
  for (int c = 0; c < grid.columns; ++c) {
    const int face = gas.layout().vFace(c, grid.rows);
    outflow += gas.fields().velocity[face] * gas.layout().faceArea[face];
    for (int r = 0; r < grid.lowestRow[c]; ++r) {  // no gas inside the stair, none through its risers
      EXPECT_EQ(gas.fields().velocity[gas.layout().uFace(c, r)], 0.0);
      EXPECT_EQ(gas.fields().velocity[gas.layout().vFace(c, r)], 0.0);
    }
  }
  EXPECT_NEAR(outflow / inflow, 1.0, 1e-11);
}

/// Where a stair of blocked cells has gas over it that thins and thickens; all that a step computes.
std::vector<double> stirred(int columns, int rows, int threads, GasScheme scheme = GasScheme::projection) {
  Scene scene = test::inclinedScene();
  scene.gas->grid.columns = {{columns, 0.096 / columns}};
  scene.gas->grid.rows = {{rows, 0.42 / rows}};
  scene.gas->scheme = scheme;
  ThreadTeam team(threads);
  GasSolver gas(scene, team);
  for (const MomentumVolume& v : gas.layout().volumes) gas.exchange().coefficient[v.face] = 5e3 * v.volume;
  std::vector<double> voidage(gas.grid().cells());
  for (int step = 0; step <= 3; ++step) {
    for (std::size_t c = 0; c < voidage.size(); ++c)
      voidage[c] = 0.6 + 0.01 * std::sin(0.7 * static_cast<double>(c) + 0.1 * step);
    if (step == 0) {
      gas.startWith(voidage);
      continue;
    }
    const GasStepReport r = gas.advance(voidage);
    EXPECT_TRUE(r.solved);
    EXPECT_LT(r.massResidual, 1e-10);
  }
  std::vector<double> all = gas.fields().velocity;
  all.insert(all.end(), gas.fields().pressure.begin(), gas.fields().pressure.end());
  return all;
}

TEST(Channel, ThreadsDoNotMatter) {
  for (const auto& [columns, rows] : {std::pair(70, 67), std::pair(1025, 5), std::pair(5, 1025)}) {
    const std::vector<double> one = stirred(columns, rows, 1);
    for (int threads : {2, 3, 4}) EXPECT_EQ(stirred(columns, rows, threads), one) << threads << " threads";
  }
  EXPECT_EQ(stirred(70, 67, 3, GasScheme::simple), stirred(70, 67, 1, GasScheme::simple));
}

TEST(Channel, VectorsDoNotMatter) {
  const SimdLevel best = bestSimdLevel();
  for (const auto& [columns, rows] : {std::pair(8, 27), std::pair(35, 14), std::pair(70, 67)}) {
    const std::vector<double> widest = stirred(columns, rows, 1);
    for (SimdLevel level : {SimdLevel::baseline, SimdLevel::avx2}) {
      if (!useSimdLevel(level)) continue;
      EXPECT_EQ(stirred(columns, rows, 1), widest) << "level " << static_cast<int>(level);
    }
    useSimdLevel(best);
  }
}

TEST(Channel, LargeGridsAreIteratedToTheSameMassBalance) {
  Scene scene = test::inclinedScene();  // 20,800 cells: beyond what is factorized
  scene.gas->grid.columns = {{160, 0.096 / 160}};
  scene.gas->grid.rows = {{130, 0.42 / 130}};
  ThreadTeam team(1);
  GasSolver gas(scene, team);
  const std::vector<double> empty(gas.grid().cells(), 1.0);
  for (int step = 0; step < 2; ++step) {
    const GasStepReport r = gas.advance(empty);
    ASSERT_TRUE(r.solved);
    EXPECT_LT(r.massResidual, 1e-10);
  }
}

}  // namespace
}  // namespace bedmix
