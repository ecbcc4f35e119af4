// SPDX-License-Identifier: MIT
#include "engine/core/rng.h"
#include "engine/coupling/voidage.h"
#include "engine/gas/gas_solver.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bedmix {
namespace {

ObstacleSettings tube(double x, double y, double radius) {
  ObstacleSettings o;
  o.x = x, o.y = y, o.radius = radius;
  return o;
}

ObstacleSettings plate(Vec2 a, Vec2 b, double thickness) {
  ObstacleSettings o;
  o.shape = ObstacleShape::segment;
  o.x1 = a.x, o.y1 = a.y, o.x2 = b.x, o.y2 = b.y;
  o.thickness = thickness;
  return o;
}

/// Gas alone past obstacles, over cells of 5 mm.
Scene pastObstacles(int columns, std::vector<ObstacleSettings> obstacles) {
  Scene scene = test::paperScene(0.5);
  scene.particles.count = 0;
  scene.bed.width = 0.005 * columns;
  scene.bed.height = 0.2;
  scene.gas->grid.columns = {{columns, 0.005}};
  scene.gas->grid.rows = {{40, 0.005}};
  scene.gas->inlets = {{0.0, scene.bed.width, 0.5, std::nullopt}};
  scene.gas->step = 1e-3;
  scene.obstacles = std::move(obstacles);
  return scene;
}

/// m3/s through the faces above a row.
double flowAbove(const GasSolver& gas, int row) {
  double flow = 0.0;
  for (int c = 0; c < gas.grid().columns; ++c)
    flow += gas.fields().velocity[gas.layout().vFace(c, row + 1)] * gas.grid().dx(c) * gas.grid().thickness;
  return flow;
}

class GasAroundATube : public testing::TestWithParam<int> {};

// 16 columns are solved directly, 24 by iterations.
TEST_P(GasAroundATube, KeepsItsMassAndItsSymmetry) {
  const int columns = GetParam();
  const Scene scene = pastObstacles(columns, {tube(0.0025 * columns, 0.08, 0.0151)});
  ThreadTeam team(1);
  GasSolver gas(scene, team);
  const std::vector<double> empty(gas.grid().cells(), 1.0);
  for (int step = 0; step < 200; ++step) {
    const GasStepReport r = gas.advance(empty);
    ASSERT_TRUE(r.solved && r.converged);
    ASSERT_LT(r.massResidual, 1e-10);
  }
  const double inflow = 0.5 * scene.bed.width * scene.bed.thickness;
  int blocked = 0;
  for (int row = 0; row < gas.grid().rows; ++row) {
    EXPECT_NEAR(flowAbove(gas, row), inflow, 1e-10 * inflow) << row;
    for (int c = 0; c < columns; ++c) {
      const int mirror = columns - 1 - c;
      const double up = gas.fields().velocity[gas.layout().vFace(c, row)];
      // To where the momentum predictor stops, 1e-6 of the largest velocity.
      EXPECT_NEAR(up, gas.fields().velocity[gas.layout().vFace(mirror, row)], 1e-6);
      EXPECT_NEAR(gas.fields().velocity[gas.layout().uFace(c, row)],
                  -gas.fields().velocity[gas.layout().uFace(mirror + 1, row)], 1e-6);
      const double fromX = (c + 0.5) * 0.005 - 0.0025 * columns, fromY = (row + 0.5) * 0.005 - 0.08;
      EXPECT_EQ(gas.grid().open(c, row), std::hypot(fromX, fromY) >= 0.0151);
      if (gas.grid().open(c, row)) continue;
      ++blocked;
      for (const int face : gas.layout().cellFaces[gas.grid().cell(c, row)])
        EXPECT_EQ(gas.fields().velocity[face], 0.0);
    }
  }
  EXPECT_EQ(blocked, 32);
  // Beside it there is less room, so that gas is faster at the walls, too, though it sticks to the tube.
  EXPECT_GT(gas.fields().velocity[gas.layout().vFace(0, 16)], 1.1 * 0.5);
}
INSTANTIATE_TEST_SUITE_P(Columns, GasAroundATube, testing::Values(16, 24));

// A slot between two plates lets through what enters, and the room that a cone closes off is no room.
TEST(GasObstacles, ClosedRoomIsBlocked) {
  const Scene scene =
      pastObstacles(16, {plate({0.0, 0.05}, {0.03, 0.0}, 0.004), plate({0.08, 0.05}, {0.05, 0.0}, 0.004)});
  const GasGrid grid = makeGasGrid(scene);
  EXPECT_FALSE(grid.open(0, 0));
  EXPECT_FALSE(grid.open(15, 2));
  EXPECT_TRUE(grid.open(7, 0));
  EXPECT_TRUE(grid.open(0, 12));
  EXPECT_EQ(grid.inletFlux[0], 0.0);
  EXPECT_GT(grid.inletFlux[7], 0.0);
  for (int c = 0; c < grid.columns; ++c)
    for (int r = 0; r < grid.rows; ++r)
      EXPECT_TRUE(grid.open(static_cast<int>(grid.openCellFor(c, r)) % 16,
                            static_cast<int>(grid.openCellFor(c, r)) / 16));
}

// Through a long slot of six cells: what walls within the bed do to the gas is what its side walls do.
TEST(GasObstacles, PlatesAreWalls) {
  Scene narrow = pastObstacles(6, {});
  Scene wide = pastObstacles(18, {});
  for (Scene* scene : {&narrow, &wide}) {
    scene->gas->viscosity = 1e-2;
    scene->gravity = 0.0;
  }
  for (const double x : {0.0275, 0.0625}) wide.obstacles.push_back(plate({x, 0.0}, {x, 0.2}, 0.004));
  wide.gas->inlets = {{0.03, 0.06, 0.5, std::nullopt}};
  ThreadTeam team(1);
  GasSolver a(narrow, team), b(wide, team);
  ASSERT_FALSE(b.grid().open(5, 20));
  ASSERT_FALSE(b.grid().open(12, 20));
  const std::vector<double> emptyA(a.grid().cells(), 1.0), emptyB(b.grid().cells(), 1.0);
  for (int step = 0; step < 100; ++step) ASSERT_TRUE(a.advance(emptyA).solved && b.advance(emptyB).solved);
  for (int row = 1; row < 40; ++row)
    for (int c = 0; c < 6; ++c)
      EXPECT_NEAR(b.fields().velocity[b.layout().vFace(c + 6, row)],
                  a.fields().velocity[a.layout().vFace(c, row)], 1e-6)
          << c << ' ' << row;
}

TEST(GasObstacles, SolidVolumeIsConservedAroundThem) {
  Scene scene = test::paperScene(1.0);
  scene.obstacles = {tube(0.04, 0.08, 0.02), plate({0.03, 0.17}, {0.08, 0.19}, 0.012)};
  const GasGrid grid = makeGasGrid(scene);
  ASSERT_FALSE(grid.open(3, 6));
  Rng rng(3);
  std::vector<Vec2> at;
  for (int i = 0; i < 300; ++i) at.push_back({rng.uniform(0.0015, 0.0945), rng.uniform(0.0015, 0.39)});
  std::vector<double> alone;
  for (const int threads : {1, 3}) {
    ThreadTeam team(threads);
    VoidageField field(scene, grid, team);
    field.update(at);
    double solids = 0.0;
    for (int r = 0; r < grid.rows; ++r)
      for (int c = 0; c < grid.columns; ++c) {
        solids += (1.0 - field.voidage()[grid.cell(c, r)]) * grid.roomOf(c, r);
        if (!grid.open(c, r)) {
          EXPECT_EQ(field.voidage()[grid.cell(c, r)], 1.0);
        }
      }
    EXPECT_NEAR(solids / (300.0 * particleVolume(scene)), 1.0, 1e-12);
    if (threads == 1) alone = field.voidage();
    EXPECT_EQ(field.voidage(), alone);
  }
}

}  // namespace
}  // namespace bedmix
