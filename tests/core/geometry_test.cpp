// SPDX-License-Identifier: MIT
#include "engine/core/gas_grid.h"
#include "engine/core/scene_reader.h"
#include "engine/core/walls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

namespace bedmix {
namespace {

Scene bundled(const std::string& name) {
  std::ifstream file(std::string(BEDMIX_SOURCE_DIR "/assets/scenes/") + name + ".toml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Result<Scene> scene = readScene(text, name);
  EXPECT_TRUE(scene) << toString(scene.problems.front());
  return *scene;
}

/// Each wall goes on where the one before it ends, and every inner corner belongs to one wall only.
void expectChain(const std::vector<WallSegment>& walls) {
  for (std::size_t i = 0; i + 1 < walls.size(); ++i) {
    EXPECT_EQ(walls[i].b, walls[i + 1].a) << "between walls " << i << " and " << i + 1;
    EXPECT_NE(walls[i].ownsB, walls[i + 1].ownsA);
  }
  for (const WallSegment& wall : walls) EXPECT_GT(norm(wall.b - wall.a), 0.0);
}

TEST(GasGrid, HoldsThePapersCells) {
  const Scene scene = bundled("tian-2007-even");
  const GasGrid grid = makeGasGrid(scene);
  EXPECT_EQ(grid.columns, 8);
  EXPECT_EQ(grid.rows, 27);
  EXPECT_EQ(grid.x.front(), 0.0);
  EXPECT_EQ(grid.x.back(), 0.096);
  EXPECT_EQ(grid.y.back(), 0.42);
  EXPECT_NEAR(grid.dy(14), 0.012, 1e-15);
  EXPECT_NEAR(grid.dy(15), 0.020, 1e-15);
  EXPECT_NEAR(grid.volume(3, 20), 0.012 * 0.020 * 0.004, 1e-18);
  EXPECT_EQ(grid.lowestRow, std::vector<int>(8, 0));
  for (double flux : grid.inletFlux) EXPECT_NEAR(flux, 2.0 * minimumFluidizationVelocity(scene), 1e-12);
}

TEST(GasGrid, BlocksAStairUnderTheIncline) {
  const Scene scene = bundled("tian-2007-inclined");
  const GasGrid grid = makeGasGrid(scene);
  EXPECT_EQ(grid.lowestRow, (std::vector<int>{0, 0, 1, 1, 1, 2, 2, 2}));
  EXPECT_FALSE(grid.open(2, 0));
  EXPECT_TRUE(grid.open(2, 1));
  const double umf = minimumFluidizationVelocity(scene);
  for (int c = 0; c < 8; ++c)
    EXPECT_NEAR(grid.inletFlux[c], (c < 2 ? 5.0 : c < 6 ? 0.0 : 3.0) * umf, 1e-12) << "column " << c;
}

TEST(GasGrid, InletsCoverColumnsInPart) {
  Scene scene = bundled("tian-2007-even");
  scene.gas->inlets = {{0.006, 0.015, 4.0, std::nullopt}, {0.090, 0.096, 1.0, std::nullopt}};
  const GasGrid grid = makeGasGrid(scene);
  EXPECT_NEAR(grid.inletFlux[0], 4.0 * 0.006 / 0.012, 1e-12);
  EXPECT_NEAR(grid.inletFlux[1], 4.0 * 0.003 / 0.012, 1e-12);
  EXPECT_NEAR(grid.inletFlux[7], 0.5, 1e-12);
  double flow = 0.0;
  for (int c = 0; c < 8; ++c) flow += grid.inletFlux[c] * grid.dx(c);
  EXPECT_NEAR(flow, 4.0 * 0.009 + 1.0 * 0.006, 1e-15);
}

TEST(Walls, FlatBedIsOpenAboveOrClosedByALid) {
  Scene scene = bundled("tian-2007-even");
  const std::vector<WallSegment> open = bedWalls(scene);
  ASSERT_EQ(open.size(), 3u);
  expectChain(open);
  EXPECT_EQ(open[1].a, (Vec2{0.0, 0.0}));
  EXPECT_EQ(open[1].b, (Vec2{0.096, 0.0}));
  EXPECT_GT(open.front().a.y, 10.0);

  scene.bed.top = BedTop::lid;
  const std::vector<WallSegment> closed = bedWalls(scene);
  ASSERT_EQ(closed.size(), 4u);
  expectChain(closed);
  EXPECT_EQ(closed.back().b, closed.front().a);
  EXPECT_EQ(closed.back().a.y, 0.42);
}

TEST(Walls, InclineIsStraightOrAStair) {
  Scene scene = bundled("tian-2007-inclined");
  const std::vector<WallSegment> straight = bedWalls(scene);
  ASSERT_EQ(straight.size(), 3u);
  expectChain(straight);
  EXPECT_NEAR(straight[1].b.y, 0.096 * std::tan(18.0 * std::numbers::pi / 180), 1e-15);

  scene.floor.shape = FloorShape::stair;
  const std::vector<WallSegment> stair = bedWalls(scene);
  ASSERT_EQ(stair.size(), 7u);  // side, three treads with two risers between them, side
  expectChain(stair);
  EXPECT_EQ(stair[1].b, (Vec2{0.024, 0.0}));
  EXPECT_EQ(stair[2].b, (Vec2{0.024, 0.012}));
  EXPECT_EQ(stair[4].b, (Vec2{0.060, 0.024}));
  EXPECT_EQ(stair[5].b, (Vec2{0.096, 0.024}));
}

}  // namespace
}  // namespace bedmix
