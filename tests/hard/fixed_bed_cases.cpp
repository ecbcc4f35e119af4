// SPDX-License-Identifier: MIT
#include "engine/core/scene_reader.h"
#include "tests/gas/fixed_bed.h"
#include "tests/gas/gas_scenes.h"
#include "tests/hard/hard_beds.h"
#include "tests/hard/hard_case.h"

namespace bedmix::hard {

namespace {

using test::FixedBed;

constexpr const char* pressureSolve = "pressure solved to 1e-12 of the inflow";
constexpr double massBound = 1e-10;

/// The paper's bed with another grid, closed by a lid, so that nothing fades towards the top.
Scene gridScene(double superficial, GridSpan columns, GridSpan rows) {
  Scene scene = test::paperScene(superficial);
  scene.gravity = 0.0;
  scene.bed.top = BedTop::lid;
  scene.bed.width = static_cast<double>(columns.count) * columns.size;
  scene.bed.height = static_cast<double>(rows.count) * rows.size;
  scene.gas->grid = {{columns}, {rows}};
  scene.gas->inlets = {{0.0, scene.bed.width, superficial, std::nullopt}};
  return scene;
}

/// Departure of the pressure drop between the centres of two rows from Ergun's; and the mass residual.
struct Drop {
  double error = 0.0, massResidual = 0.0;
};
Drop dropOf(const Scene& scene, const std::vector<Vec2>& centres, int from, int to, double eps, int steps) {
  FixedBed bed(scene, centres);
  Drop drop;
  for (int i = 0; i < steps; ++i) {
    const GasStepReport r = bed.step();
    if (!r.solved) throw std::runtime_error("the gas has no finite solution");
    drop.massResidual = std::max(drop.massResidual, r.massResidual);
  }
  const GasGrid& grid = bed.gas.grid();
  double difference = 0.0;
  for (int c = 0; c < grid.columns; ++c)
    difference +=
        (bed.gas.fields().pressure[grid.cell(c, from)] - bed.gas.fields().pressure[grid.cell(c, to)]) *
        grid.dx(c) / scene.bed.width;
  const double length = 0.5 * (grid.y[to] + grid.y[to + 1] - grid.y[from] - grid.y[from + 1]);
  const double u = grid.inletFlux[0];
  drop.error =
      std::abs(difference / std::copysign(length * test::ergunGradient(eps, std::abs(u), scene), u) - 1.0);
  return drop;
}

/// What Ergun's drop lacks: the gas's friction at the side walls, at most that of the steepest profile the
/// cells can hold, 2 mu (u/eps)/(dx/2) over a width.
double wallShare(const Scene& scene, double eps) {
  const double dx = scene.gas->grid.columns[0].size, u = std::abs(*scene.gas->inlets[0].velocity);
  return 4.0 * scene.gas->viscosity * u / (eps * dx * scene.bed.width) / test::ergunGradient(eps, u, scene);
}
constexpr const char* wallFriction = "friction at the side walls, at most 4 mu u/(eps dx W)";

// Spheres in cubes of their diameter: the same voidage wherever cells cut them.
std::vector<Check> ergun(const Scene& scene, int from, int to, int steps = 400) {
  const double eps = 1.0 - pi / 6.0;
  const Drop drop = dropOf(scene, test::squareLattice(scene), from, to, eps, steps);
  return {{"pressure drop over Ergun's, less 1", wallShare(scene, eps) + 1e-6, wallFriction, drop.error},
          {"mass residual of any cell and step", massBound, pressureSolve, drop.massResidual}};
}

std::vector<Check> smallCells() { return ergun(gridScene(1.3, {16, 0.006}, {40, 0.006}), 2, 36); }
std::vector<Check> largeCells() { return ergun(gridScene(1.3, {4, 0.04}, {8, 0.04}), 1, 6); }
std::vector<Check> flatCells() { return ergun(gridScene(1.3, {3, 0.032}, {60, 0.004}), 3, 55); }
std::vector<Check> tallCells() { return ergun(gridScene(1.3, {24, 0.004}, {10, 0.032}), 1, 8); }

std::vector<Check> largeGasStep() {
  Scene scene = gridScene(1.3, {8, 0.012}, {20, 0.012});
  scene.gas->step = 1e-2;
  return ergun(scene, 1, 17, 100);
}

std::vector<Check> reversed() {
  const Scene scene = gridScene(-1.3, {8, 0.012}, {20, 0.012});
  std::vector<Check> checks = ergun(scene, 1, 17);
  checks.push_back({"let pass by check, 1 = yes", 0.0, "gas may only enter",
                    readScene(writeScene(scene), "reversed") ? 1.0 : 0.0});
  return checks;
}

std::vector<Check> water() {
  Scene scene = gridScene(0.2, {8, 0.012}, {20, 0.012});
  scene.gas->density = 1500.0;
  scene.gas->viscosity = 1e-3;
  return ergun(scene, 1, 17, 20000);
}

/// Hexagonally packed spheres, 2.8 % closer than they touch: voidage 0.36 in a slab of a diameter.
std::vector<Vec2> dense(const Scene& scene, double right, double top) {
  const double spacing = scene.particles.diameter * std::sqrt(pi / (3.0 * std::sqrt(3.0)) / 0.64);
  std::vector<Vec2> centres;
  const double rise = spacing * std::sqrt(3.0) / 2.0;
  for (int row = 0; (row + 0.5) * rise < top; ++row)
    for (double x = spacing * (0.25 + 0.5 * (row % 2)); x < right; x += spacing)
      centres.push_back({x, (row + 0.5) * rise});
  return centres;
}

std::vector<Check> denseBesideEmpty() {
  const Scene scene = gridScene(1.3, {8, 0.012}, {20, 0.012});
  FixedBed bed(scene, dense(scene, 0.048, 0.24));
  double residual = 0.0, lowest = 1.0;
  for (int i = 0; i < 2000; ++i) {
    const GasStepReport r = bed.step();
    if (!r.solved) throw std::runtime_error("the gas has no finite solution");
    residual = std::max(residual, r.massResidual);
  }
  const GasGrid& grid = bed.gas.grid();
  const GasFields& gas = bed.gas.fields();
  // At mid-height the gradient is the same on both sides; the dense one carries what Ergun gives for it.
  const auto gradient = [&](int c) {
    return (gas.pressure[grid.cell(c, 9)] - gas.pressure[grid.cell(c, 11)]) / 0.024;
  };
  double flow = 0.0, eps = 0.0;
  for (int c = 1; c < 3; ++c) {
    const double voidage = gas.voidage[grid.cell(c, 10)];
    lowest = std::min(lowest, voidage);
    eps += voidage / 2.0;
    flow += voidage * gas.velocity[bed.gas.layout().vFace(c, 10)] / 2.0;
  }
  const double ergun = test::ergunGradient(eps, flow, scene);
  return {{"lowest voidage inside the dense half, off 0.36", 0.02,
           "the kernel is a square, the lattice hexagonal", std::abs(lowest - 0.36)},
          {"gradient in the dense half over Ergun's at its own flow, less 1", 0.1,
           "voidage differs by 0.02 between cells, Ergun's gradient by five times that",
           std::abs(gradient(1) / ergun - 1.0)},
          {"mass residual of any cell and step", massBound, pressureSolve, residual}};
}

std::vector<Check> narrowInlet() {
  Scene scene = gridScene(0.0, {8, 0.012}, {20, 0.012});
  scene.gas->inlets = {{0.0415, 0.0445, 8.0, std::nullopt}};
  FixedBed bed(scene, {});
  double residual = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const GasStepReport r = bed.step();
    if (!r.solved) throw std::runtime_error("the gas has no finite solution");
    residual = std::max(residual, r.massResidual);
  }
  double out = 0.0;
  for (int c = 0; c < 8; ++c) out += 0.012 * bed.gas.fields().velocity[bed.gas.layout().vFace(c, 20)];
  return {{"what leaves over what enters, less 1", massBound * 160.0, "mass residual of 160 cells",
           std::abs(out / (8.0 * 0.003) - 1.0)},
          {"mass residual of any cell and step", massBound, pressureSolve, residual}};
}

}  // namespace

std::vector<HardCase> fixedBedCases() {
  return {{"gas cells of 1.5 d", smallCells},
          {"gas cells of 10 d", largeCells},
          {"gas cells 8 times as wide as high", flatCells},
          {"gas cells 8 times as high as wide", tallCells},
          {"gas step 100 times the default", largeGasStep},
          {"reversed inflow: refused; forced, fixed bed", reversed},
          {"gas as dense as the spheres, fixed bed", water},
          {"voidage 0.36 beside empty cells", denseBesideEmpty},
          {"inlet a quarter of a cell wide", narrowInlet}};
}

}  // namespace bedmix::hard
