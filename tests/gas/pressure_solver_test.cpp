// SPDX-License-Identifier: MIT
#include "engine/gas/pressure_solver.h"

#include "engine/core/rng.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bedmix {
namespace {

struct Solution {
  int iterations;
  double residual;  // largest, over the largest of b
};

/// Solves for a random right-hand side on the inclined bed; conductances vary at random over `decades`.
Solution solve(int columns, int rows, double decades) {
  Scene scene = test::inclinedScene();
  scene.gas->grid.columns = {{columns, 0.096 / columns}};
  scene.gas->grid.rows = {{rows, 0.42 / rows}};
  const GasGrid grid = makeGasGrid(scene);
  const FaceLayout layout = makeFaceLayout(grid);
  PressureSolver solver(layout);
  Rng rng(1);
  std::vector<double> coefficient, b(grid.cells()), p(grid.cells());
  for (const MomentumVolume& v : layout.volumes)
    coefficient.push_back(v.area * v.area / v.volume * std::pow(10.0, decades * (rng.uniform() - 0.5)));
  for (int c : layout.openCells) b[c] = rng.uniform() - 0.5;
  EXPECT_TRUE(solver.prepare(coefficient));
  solver.solve(b, p);

  std::vector<double> residual = b;
  for (std::size_t k = 0; k < layout.volumes.size(); ++k) {
    const MomentumVolume& v = layout.volumes[k];
    const double flow = coefficient[k] * (p[v.cellMinus] - (v.cellPlus < 0 ? 0.0 : p[v.cellPlus]));
    residual[v.cellMinus] -= flow;
    if (v.cellPlus >= 0) residual[v.cellPlus] += flow;
  }
  double largest = 0.0;
  for (int c : layout.openCells) largest = std::max(largest, std::abs(residual[c]));
  return {solver.iterations(), largest / 0.5};
}

TEST(PressureSolver, SmallGridsAreSolvedDirectly) {
  const Solution s = solve(8, 35, 3.0);
  EXPECT_EQ(s.iterations, 0);
  EXPECT_LT(s.residual, 1e-10);
}

TEST(PressureSolver, IterationsDoNotGrowWithTheGrid) {
  for (double decades : {0.0, 1.0}) {
    const Solution small = solve(160, 160, decades), large = solve(640, 640, decades);
    EXPECT_GT(small.iterations, 0);
    EXPECT_LE(large.iterations, small.iterations + 2);
    EXPECT_LE(large.iterations, 25);
    EXPECT_LT(small.residual, 1e-9);
    EXPECT_LT(large.residual, 1e-9);
  }
}

TEST(PressureSolver, CellsThatAreLongOneWay) {
  const Solution wide = solve(40, 1200, 0.0), tall = solve(1200, 40, 0.0);
  EXPECT_LE(wide.iterations, 25);
  EXPECT_LE(tall.iterations, 25);
  EXPECT_LT(wide.residual, 1e-9);
  EXPECT_LT(tall.residual, 1e-9);
}

TEST(PressureSolver, RefusesCoefficientsThatAreNotFinite) {
  const FaceLayout layout = makeFaceLayout(makeGasGrid(test::paperScene(1.0)));
  PressureSolver solver(layout);
  std::vector<double> coefficient(layout.volumes.size(), 1.0);
  EXPECT_TRUE(solver.prepare(coefficient));
  coefficient[17] = std::nan("");
  EXPECT_FALSE(solver.prepare(coefficient));
}

}  // namespace
}  // namespace bedmix
