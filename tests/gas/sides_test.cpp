// SPDX-License-Identifier: MIT
#include "engine/core/rng.h"
#include "engine/gas/gas_solver.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

using std::numbers::pi;

/// A gas without particles between periodic sides.
Scene openGas(int columns, double velocity) {
  Scene scene = test::paperScene(velocity);
  scene.gravity = 0.0;
  scene.bed.sides = BedSides::periodic;
  scene.bed.width = 0.1;
  scene.bed.height = 0.4;
  scene.gas->density = 1.0;
  scene.gas->viscosity = 0.1;
  scene.gas->step = 2e-3;
  scene.gas->grid.columns = {{columns, 0.1 / columns}};
  scene.gas->grid.rows = {{20, 0.02}};
  scene.gas->inlets = {{0.0, 0.1, velocity, std::nullopt}};
  return scene;
}

// Without walls there is no layer at them; compare Channel.ProfileIsParabolic...
TEST(PeriodicGas, UniformFlowStaysUniform) {
  for (const GasScheme scheme : {GasScheme::projection, GasScheme::simple}) {
    Scene scene = openGas(8, 0.3);
    scene.gas->scheme = scheme;
    ThreadTeam team(1);
    GasSolver gas(scene, team);
    const std::vector<double> empty(gas.grid().cells(), 1.0);
    for (int step = 0; step < 50; ++step) {
      const GasStepReport r = gas.advance(empty);
      ASSERT_TRUE(r.solved && r.converged);
      EXPECT_LT(r.massResidual, 1e-10);
    }
    for (int j = 0; j <= gas.grid().rows; ++j)
      for (int i = 0; i < gas.grid().columns; ++i) {
        EXPECT_NEAR(gas.fields().velocity[gas.layout().vFace(i, j)], 0.3, 1e-9);
        if (j < gas.grid().rows) {
          EXPECT_NEAR(gas.fields().velocity[gas.layout().uFace(i, j)], 0.0, 1e-9);
        }
      }
  }
}

/// A force F cos(k x + phase) per volume, upward, on all level faces.
void pushInWaves(GasSolver& gas, double force, double phase) {
  const FaceLayout& layout = gas.layout();
  for (const MomentumVolume& v : layout.volumes) {
    if (!v.vertical) continue;
    const int column = v.cellMinus % layout.columns;
    const double x = 0.5 * (gas.grid().x[column] + gas.grid().x[column + 1]);
    gas.exchange().source[v.face] = force * v.volume * std::cos(20.0 * pi * x + phase);
  }
}

/// Of the flow of that wavelength half way up, m/s.
double amplitude(const GasSolver& gas, double phase) {
  double sum = 0.0;
  const int n = gas.grid().columns;
  for (int i = 0; i < n; ++i) {
    const double x = 0.5 * (gas.grid().x[i] + gas.grid().x[i + 1]);
    sum += 2.0 / n * std::cos(20.0 * pi * x + phase) * gas.fields().velocity[gas.layout().vFace(i, 10)];
  }
  return sum;
}

// Kolmogorov flow: F cos(k x) drives v = F/(mu k2) cos(k x), and left alone that decays as exp(-nu k2 t);
// half way up the inlet is felt to exp(-k y) = 4e-6. The phase puts a slope on the seam.
TEST(PeriodicGas, ShearWaveHasItsClosedForm) {
  const double k2 = 400.0 * pi * pi, mu = 0.1, force = 0.05 * mu * k2, phase = 1.0;
  double previous = 0.0, previousRate = 0.0;
  for (const int columns : {8, 16, 32}) {
    Scene scene = openGas(columns, 0.1);
    scene.gas->step = 2e-4;
    ThreadTeam team(1);
    GasSolver gas(scene, team);
    const std::vector<double> empty(gas.grid().cells(), 1.0);
    pushInWaves(gas, force, phase);
    for (int step = 0; step < 1000; ++step) ASSERT_TRUE(gas.advance(empty).solved);
    const double error = std::abs(amplitude(gas, phase) / 0.05 - 1.0);
    pushInWaves(gas, 0.0, phase);
    const double before = amplitude(gas, phase);
    for (int step = 0; step < 10; ++step) ASSERT_TRUE(gas.advance(empty).solved);
    const double rate = std::log(before / amplitude(gas, phase)) / (10 * 2e-4);
    const double rateError = std::abs(rate / (mu * k2) - 1.0);
    if (previous > 0.0) {
      EXPECT_NEAR(std::log2(previous / error), 2.0, 0.1);
      EXPECT_NEAR(std::log2(previousRate / rateError), 2.0, 0.2);
    }
    previous = error;
    previousRate = rateError;
  }
  EXPECT_LT(previous, 4e-3);
  EXPECT_LT(previousRate, 5e-3);
}

/// A jet through a gas that thins and thickens, with everything `shift` columns to the right.
struct Shifted {
  Scene scene;
  ThreadTeam team;
  GasSolver gas;
  double massResidual = 0.0;

  Shifted(int columns, int shift, GasScheme scheme, int threads)
      : scene(sceneOf(columns, shift, scheme)), team(threads), gas(scene, team) {
    for (const MomentumVolume& v : gas.layout().volumes) gas.exchange().coefficient[v.face] = 5e2 * v.volume;
    std::vector<double> voidage(gas.grid().cells());
    for (int step = 0; step <= 20; ++step) {
      for (int j = 0; j < gas.grid().rows; ++j)
        for (int i = 0; i < columns; ++i) {
          const int from = gas.grid().columnAround(i - shift);
          voidage[gas.grid().cell(i, j)] = 0.6 + 0.05 * std::sin(0.9 * from * from + 0.4 * j + 0.1 * step);
        }
      if (step == 0) {
        gas.startWith(voidage);
        continue;
      }
      const GasStepReport r = gas.advance(voidage);
      EXPECT_TRUE(r.solved);
      massResidual = std::max(massResidual, r.massResidual);
    }
  }
  static Scene sceneOf(int columns, int shift, GasScheme scheme) {
    Scene scene = test::paperScene(0.0);
    scene.bed.sides = BedSides::periodic;
    const double width = 0.096 / columns;
    scene.gas->grid.columns = {{columns, width}};
    scene.gas->scheme = scheme;
    scene.gas->inlets.clear();
    for (const int column : {columns / 2, columns / 2 + 1}) {
      const double from = ((column + shift) % columns) * width;
      scene.gas->inlets.push_back({from, from + width, 4.0, std::nullopt});
    }
    return scene;
  }
};

// The seam may be anywhere, also within the jet.
TEST(PeriodicGas, FieldsGoWithTheirInlets) {
  for (const GasScheme scheme : {GasScheme::projection, GasScheme::simple})
    for (const int columns : {8, 9, 60}) {  // of 60 the pressure is solved by iterations
      const Shifted here(columns, 0, scheme, 1);
      EXPECT_LT(here.massResidual, 1e-10);
      for (const int shift : {1, columns / 2 - 1}) {
        const Shifted there(columns, shift, scheme, 1);
        EXPECT_LT(there.massResidual, 1e-10);
        const GasGrid& grid = here.gas.grid();
        const FaceLayout& layout = here.gas.layout();
        const std::vector<double>&a = here.gas.fields().velocity, &b = there.gas.fields().velocity;
        double largest = 0.0, sideways = 0.0;
        for (int j = 0; j < grid.rows; ++j)
          for (int i = 0; i < columns; ++i) {
            const int to = (i + shift) % columns;
            largest = std::max({largest, std::abs(a[layout.uFace(i, j)] - b[layout.uFace(to, j)]),
                                std::abs(a[layout.vFace(i, j)] - b[layout.vFace(to, j)])});
            sideways = std::max(sideways, std::abs(a[layout.uFace(i, j)]));
          }
        EXPECT_GT(sideways, 0.1);
        EXPECT_LT(largest, columns < 50 ? 1e-8 : 2e-6) << columns << " columns, shifted by " << shift;
      }
    }
}

struct AroundSolution {
  int iterations;
  double residual;  // largest, over the largest of b
};

/// Solves for a random right-hand side, written out face by face; conductances vary by a factor of ten.
AroundSolution solvePressure(int columns, int rows) {
  Scene scene = Shifted::sceneOf(columns, 0, GasScheme::projection);
  scene.gas->grid.rows = {{rows, 0.42 / rows}};
  const FaceLayout layout = makeFaceLayout(makeGasGrid(scene));
  PressureSolver solver(layout, 1);
  Rng rng(1);
  std::vector<double> conductance(layout.faces()), b(layout.size), p(layout.size);
  for (const MomentumVolume& v : layout.volumes)
    conductance[v.face] = v.area * v.area / v.volume * std::pow(10.0, rng.uniform() - 0.5);
  Member alone;
  layout.copyAround(alone, conductance);
  const auto place = [&](int cell) { return layout.at(cell % columns, cell / columns); };
  for (const int c : layout.openCells) b[place(c)] = rng.uniform() - 0.5;
  EXPECT_TRUE(solver.prepare(alone, conductance));
  const int iterations = solver.solve(alone, b, p, {1e-12, 0.0});
  std::vector<double> residual = b;
  int onSeam = 0;
  for (const MomentumVolume& v : layout.volumes) {
    const int minus = place(v.cellMinus), plus = v.cellPlus < 0 ? -1 : place(v.cellPlus);
    onSeam += !v.vertical && v.cellMinus % columns == columns - 1 && v.cellPlus % columns == 0;
    const double flow = conductance[v.face] * (p[minus] - (plus < 0 ? 0.0 : p[plus]));
    residual[minus] -= flow;
    if (plus >= 0) residual[plus] += flow;
  }
  EXPECT_EQ(onSeam, rows);
  double largest = 0.0;
  for (const int c : layout.openCells) largest = std::max(largest, std::abs(residual[place(c)]));
  return {iterations, largest / 0.5};
}

TEST(PeriodicGas, PressureIsSolvedAroundTheSeam) {
  for (const auto& [columns, rows] :
       {std::pair(4, 10), std::pair(9, 30), std::pair(32, 30), std::pair(31, 5)}) {
    const AroundSolution s = solvePressure(columns, rows);
    EXPECT_EQ(s.iterations, 0);
    EXPECT_LT(s.residual, 1e-10);
  }
  const AroundSolution small = solvePressure(80, 80), large = solvePressure(320, 320);
  EXPECT_GT(small.iterations, 0);
  EXPECT_LE(small.iterations, 80);
  EXPECT_LE(large.iterations, 80);
  EXPECT_LT(small.residual, 1e-9);
  EXPECT_LT(large.residual, 1e-9);
  for (const auto& [columns, rows] : {std::pair(40, 400), std::pair(400, 40), std::pair(123, 45)})
    EXPECT_LT(solvePressure(columns, rows).residual, 1e-9);
}

// A grid large enough to be shared.
TEST(PeriodicGas, ThreadsChangeNoBit) {
  const auto velocities = [](int threads) {
    Scene scene = Shifted::sceneOf(24, 11, GasScheme::projection);
    scene.gas->grid.rows = {{200, 0.0021}};
    ThreadTeam team(threads);
    GasSolver gas(scene, team);
    std::vector<double> voidage(gas.grid().cells(), 0.7);
    for (int step = 0; step < 5; ++step) {
      voidage[30] = 0.7 + 0.01 * step;
      EXPECT_TRUE(gas.advance(voidage).solved);
    }
    return gas.fields().velocity;
  };
  const std::vector<double> alone = velocities(1);
  EXPECT_EQ(velocities(2), alone);
  EXPECT_EQ(velocities(3), alone);
}

}  // namespace
}  // namespace bedmix
