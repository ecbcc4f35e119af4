// SPDX-License-Identifier: MIT
#include "engine/gas/pressure_solver.h"

#include "engine/core/rng.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

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
  PressureSolver solver(layout, 1);
  Rng rng(1);
  std::vector<double> coefficient(layout.faces()), b(layout.size), p(layout.size);
  for (const MomentumVolume& v : layout.volumes)
    coefficient[v.face] = v.area * v.area / v.volume * std::pow(10.0, decades * (rng.uniform() - 0.5));
  const auto place = [&](int cell) { return layout.at(cell % columns, cell / columns); };
  for (int c : layout.openCells) b[place(c)] = rng.uniform() - 0.5;
  Member alone;
  EXPECT_TRUE(solver.prepare(alone, coefficient));
  const int iterations = solver.solve(alone, b, p, {1e-12, 0.0});

  std::vector<double> residual = b;
  for (const MomentumVolume& v : layout.volumes) {
    const int minus = place(v.cellMinus), plus = v.cellPlus < 0 ? -1 : place(v.cellPlus);
    const double flow = coefficient[v.face] * (p[minus] - (plus < 0 ? 0.0 : p[plus]));
    residual[minus] -= flow;
    if (plus >= 0) residual[plus] += flow;
  }
  double largest = 0.0;
  for (int c : layout.openCells) largest = std::max(largest, std::abs(residual[place(c)]));
  return {iterations, largest / 0.5};
}

TEST(PressureSolver, NarrowGridsAreSolvedDirectly) {
  for (const auto& [columns, rows] :
       {std::pair(8, 35), std::pair(35, 7), std::pair(1, 5), std::pair(16, 200)}) {
    const Solution s = solve(columns, rows, 3.0);
    EXPECT_EQ(s.iterations, 0);
    EXPECT_LT(s.residual, 1e-10);
  }
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

// Conductances over eight decades: the iteration does not get through, the factorization does.
TEST(PressureSolver, WhatDoesNotConvergeIsSolvedDirectly) {
  const Solution s = solve(40, 60, 8.0);
  EXPECT_EQ(s.iterations, PressureSolver::mostIterations);
  EXPECT_LT(s.residual, 1e-8);
}

TEST(PressureSolver, RefusesCoefficientsThatAreNotFinite) {
  const FaceLayout layout = makeFaceLayout(makeGasGrid(test::paperScene(1.0)));
  PressureSolver solver(layout, 1);
  std::vector<double> coefficient = layout.solved;
  Member alone;
  EXPECT_TRUE(solver.prepare(alone, coefficient));
  coefficient[layout.vFace(3, 17)] = std::nan("");
  EXPECT_FALSE(solver.prepare(alone, coefficient));
}

}  // namespace
}  // namespace bedmix
