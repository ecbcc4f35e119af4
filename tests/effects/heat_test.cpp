// SPDX-License-Identifier: MIT
#include "engine/core/walls.h"
#include "engine/coupling/exchange.h"
#include "engine/dem/particle_solver.h"
#include "engine/effects/heat_stage.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <vector>

namespace bedmix::test {
namespace {

using std::numbers::pi;

HeatSettings& heatOf(Scene& scene) {
  auto& heat = scene.effects.at<HeatSettings>();
  if (!heat) {
    heat.emplace();
    heat->heatCapacity = 840.0;
    heat->conductivity = 1.0;
    if (scene.gas) heat->gas.emplace();
  }
  return *heat;
}

double particleHeatCapacity(const Scene& scene) {
  return particleMass(scene) * scene.effects.find<HeatSettings>()->heatCapacity;
}

/// A bed with its heat, of which every part can be looked at.
struct WarmBed {
  Scene scene;
  ThreadTeam team{1};
  std::unique_ptr<ParticleSolver> solver;
  std::unique_ptr<GasSolver> gas;
  std::unique_ptr<VoidageField> voidage;
  std::unique_ptr<Exchange> exchange;
  std::vector<double> temperature;  // K
  std::unique_ptr<HeatStage> heat;

  WarmBed(const Scene& s, const std::vector<Vec2>& centres) : scene(s) {
    scene.particles.count = static_cast<std::int64_t>(centres.size());
    solver = ParticleSolver::make(scene, makeParticles(scene, centres), bedWalls(scene), team);
    if (scene.gas) {
      gas = std::make_unique<GasSolver>(scene, team);
      voidage = std::make_unique<VoidageField>(scene, gas->grid(), team);
      exchange = std::make_unique<Exchange>(scene, *gas, *voidage, team);
      solver->particles().addExternalForces();
      voidage->update(solver->particles().position);
      gas->startWith(voidage->voidage());
    }
    heat = std::make_unique<HeatStage>(
        EffectContext{scene, *solver, gas.get(), voidage.get(), exchange.get(), team, temperature});
  }
  /// Contact lists at the particles' places, which they do not leave.
  void findContacts() { ASSERT_FALSE(solver->advance(0)); }
  /// Gas and heat, around particles at rest.
  void stepGas() {
    voidage->update(solver->particles().position);
    exchange->evaluateDrag(solver->particles(), gas->exchange());
    ASSERT_TRUE(gas->advance(voidage->voidage()).solved);
    exchange->applyForces(solver->particles());
    heat->act(scene.gas->step, scene.gas->step);
  }
  void step() {
    ASSERT_FALSE(solver->advance(stepsPerGasStep(scene)));
    stepGas();
  }

  double particleHeat() const {  // J
    const std::vector<double>& t = temperature;
    return particleHeatCapacity(scene) * std::accumulate(t.begin(), t.end(), 0.0);
  }
  double perVolume() const {
    return scene.gas->density * heatOf(const_cast<Scene&>(scene)).gas->heatCapacity;
  }
  double gasHeat() const {  // J
    double sum = 0.0;
    for (const int c : gas->layout().openCells)
      sum += perVolume() * gas->fields().voidage[c] * gas->layout().cellVolume[c] * gasTemperature(c);
    return sum;
  }
  double gasTemperature(int cell) const { return (*heat->gasTemperature())[cell]; }
  /// What comes in less what goes out with the gas, W.
  double inflow() const {
    const HeatSettings& settings = *scene.effects.find<HeatSettings>();
    double sum = 0.0;
    for (const FloorFace& f : gas->layout().floor) sum += f.flux * settings.inletTemperature();
    for (int i = 0; i < gas->grid().columns; ++i) {
      const int cell = static_cast<int>(gas->grid().cell(i, gas->grid().rows - 1));
      const int face = gas->layout().cellFaces[cell][3];
      sum -= gas->fields().velocity[face] * gas->faceVoidage()[face] * gas->layout().faceArea[face] *
             gasTemperature(cell);
    }
    return sum * perVolume();
  }
};

/// Gunn (1978) as printed.
double gunn(double e, double re, double pr) {
  return (7 - 10 * e + 5 * e * e) * (1 + 0.7 * std::pow(re, 0.2) * std::cbrt(pr)) +
         (1.33 - 2.4 * e + 1.2 * e * e) * std::pow(re, 0.7) * std::cbrt(pr);
}

TEST(Heat, NusseltNumberIsGunns) {
  const double voidage[]{1.0, 1.0, 0.4, 0.4, 0.7, 0.9}, reynolds[]{0.0, 100.0, 0.0, 500.0, 37.0, 1e4};
  double nusselt[6];
  gunnNusselt(0.71, 6, voidage, reynolds, nusselt);
  EXPECT_DOUBLE_EQ(nusselt[0], 2.0);  // a sphere in a medium at rest
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(nusselt[i] / gunn(voidage[i], reynolds[i], 0.71), 1.0, 1e-13) << i;
}

TEST(Heat, SphereInAStreamRelaxes) {
  Scene scene;
  scene.bed = {0.2, 0.4, 0.1, BedTop::open};
  scene.particles.density = 2500.0;
  scene.gas.emplace();
  scene.gas->grid = {{{4, 0.05}}, {{8, 0.05}}};
  scene.gas->inlets = {{0.0, 0.2, 2.0, std::nullopt}};
  scene.gas->step = 0.002;
  heatOf(scene).temperature = 400.0;
  const Vec2 at{0.075, 0.2};  // in the middle of a level face
  WarmBed bed(scene, {at});
  bed.findContacts();
  for (int i = 0; i < 200; ++i) bed.stepGas();

  const int cell = static_cast<int>(bed.gas->grid().cell(1, 3));
  const double speed = bed.gas->fields().velocity[bed.gas->layout().cellFaces[cell][3]];
  const double d = scene.particles.diameter, e = bed.gas->fields().voidage[cell];
  const HeatGasSettings& air = *heatOf(scene).gas;
  const double re = e * scene.gas->density * speed * d / scene.gas->viscosity;
  const double h =
      gunn(e, re, air.heatCapacity * scene.gas->viscosity / air.conductivity) * air.conductivity / d;
  const double tau = particleHeatCapacity(scene) / (h * pi * d * d);
  const double start = bed.temperature[0] - air.temperature;
  const int steps = static_cast<int>(tau / scene.gas->step);
  for (int i = 0; i < steps; ++i) bed.stepGas();
  const double left = (bed.temperature[0] - air.temperature) / start;
  // The gas around is warmed by h A over the heat capacity of what flows through a cell.
  const double warmed = h * pi * d * d / (bed.perVolume() * speed * 0.05 * 0.1);
  EXPECT_LT(warmed, 2e-3);
  EXPECT_NEAR(-std::log(left) / (steps * scene.gas->step / tau), 1.0, 2.0 * warmed);
}

/// Spheres of 4 mm in a square lattice that fills a bed one cell wide, through which gas flows.
Scene columnScene(double speed) {
  Scene scene = lowScene(0, speed);
  scene.bed.width = 0.008;
  scene.bed.height = 0.4;
  scene.gas->grid = {{{1, 0.008}}, {{50, 0.008}}};
  scene.gas->inlets = {{0.0, 0.008, speed, std::nullopt}};
  heatOf(scene).conductivity = 0.0;
  heatOf(scene).gas->inletTemperature = 400.0;
  heatOf(scene).gas->conductivity = 1e-9;  // along the stream
  return scene;
}

/// h A of all particles in a cell over the heat capacity of the gas that flows through it.
double transferUnits(const WarmBed& bed, double speed) {
  const Scene& scene = bed.scene;
  const HeatGasSettings& air = *scene.effects.find<HeatSettings>()->gas;
  const int cell = static_cast<int>(bed.gas->grid().cell(0, 20));
  const double d = scene.particles.diameter, e = bed.gas->fields().voidage[cell];
  const double re = scene.gas->density * speed * d / scene.gas->viscosity;
  const double h =
      gunn(e, re, air.heatCapacity * scene.gas->viscosity / air.conductivity) * air.conductivity / d;
  return 4.0 * h * pi * d * d / (bed.perVolume() * speed * 0.008 * scene.bed.thickness);
}

TEST(Heat, GasComesToTheTemperatureOfAFixedBed) {
  Scene scene = columnScene(1.0);
  heatOf(scene).heatCapacity = 1e12;  // particles stay what they are
  for (const double conductivity : {1e-6, 1e-4}) {
    heatOf(scene).gas->conductivity = conductivity;
    WarmBed bed(scene, squareLattice(scene));
    bed.findContacts();
    for (int i = 0; i < 10000; ++i) bed.stepGas();
    const double units = transferUnits(bed, 1.0);
    const double start = 400.0 - 293.15;
    for (const int row : {9, 19, 39}) {
      const double left = (bed.gasTemperature(row) - 293.15) / start;
      // Upwind: 1/(1 + NTU) a cell, which is exp(-NTU) but for half of NTU^2.
      EXPECT_NEAR(std::log(left), -units * (row + 1), 0.51 * units * units * (row + 1)) << conductivity;
      EXPECT_NEAR(std::log(left), -std::log1p(units) * (row + 1), 1e-6 * (row + 1)) << conductivity;
    }
  }
}

/// Schumann (1929), J. Franklin Inst. 208:405: the share of the inlet's temperature that the gas has at depth
/// y and time z, both dimensionless.
double schumannGas(double y, double z) {
  const int n = 4000;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    const double s = y * (i + 0.5) / n;
    sum += std::exp(-s - z) * std::cyl_bessel_i(0.0, 2.0 * std::sqrt(s * z)) * y / n;
  }
  return 1.0 - sum;
}

TEST(Heat, FrontThroughAFixedBedIsSchumanns) {
  Scene scene = columnScene(1.0);
  heatOf(scene).gas->conductivity = 2e-4;
  heatOf(scene).heatCapacity = 10.0;  // so that the front gets on
  scene.gas->step = 5e-4;
  WarmBed bed(scene, squareLattice(scene));
  bed.findContacts();
  const int steps = 4800;
  for (int i = 0; i < steps; ++i) bed.stepGas();
  const double units = transferUnits(bed, 1.0);
  const double perStep = units * bed.perVolume() * 0.008 * scene.bed.thickness * scene.gas->step / 4.0 /
                         particleHeatCapacity(scene);
  const double e = bed.gas->fields().voidage[20];
  int steep = 0;
  for (int row = 4; row < 50; row += 5) {
    const double y = units * (row + 0.5);
    const double z = perStep * (steps - (row + 0.5) * 0.008 * e / 1.0 / scene.gas->step);
    const double expected = schumannGas(y, z), is = (bed.gasTemperature(row) - 293.15) / (400.0 - 293.15);
    EXPECT_NEAR(is, expected, 0.012) << row;
    steep += expected > 0.1 && expected < 0.9;
  }
  EXPECT_GE(steep, 8);
}

TEST(Heat, TouchingSpheresComeToTheirMean) {
  Scene scene;
  scene.bed = {0.1, 0.1, 0.004, BedTop::open};
  scene.contacts.restitution = 0.9;
  heatOf(scene).temperature = 300.0;
  heatOf(scene).tracerTemperature = 400.0;
  const double overlap = 2e-5, radius = scene.particles.diameter / 2.0;
  const std::vector<Vec2> centres{{0.05 - radius + overlap / 2, 0.05}, {0.05 + radius - overlap / 2, 0.05}};
  for (const bool real : {false, true}) {
    if (real) heatOf(scene).youngsModulus = 60e9;
    WarmBed bed(scene, centres);
    bed.findContacts();
    const double hertz = 3.0 * (*scene.contacts.stiffness * overlap) * (radius / 2.0) /
                         (4.0 * 60e9 / (2.0 * (1.0 - 0.25 * 0.25)));
    const double area = real ? std::cbrt(hertz) : std::sqrt(radius * overlap);
    const double tau = particleHeatCapacity(scene) / (2.0 * (2.0 * 1.0 * area));
    const int steps = 10000;
    for (int i = 0; i < steps; ++i) bed.heat->act(tau / steps, tau / steps);
    const std::vector<double>& t = bed.temperature;
    EXPECT_NEAR((t[0] - t[1]) / 100.0, std::exp(-1.0), 1e-4);
    EXPECT_NEAR(t[0] + t[1], 700.0, 1e-10);
  }
}

TEST(Heat, ContactsOfHertzianSpringsAreTheirs) {
  Scene scene;
  scene.contacts.stiffness.reset();
  scene.contacts.hertz.emplace();  // 10 MPa
  heatOf(scene).conductivity = 1.0;
  const double overlap = 2e-5, radius = 1e-3;
  EXPECT_DOUBLE_EQ(ConductionLaw(scene).contactRadius(overlap, radius), std::sqrt(overlap * radius));
  heatOf(scene).youngsModulus = 80e6;  // eight times as stiff: half as wide under the same force
  EXPECT_NEAR(ConductionLaw(scene).contactRadius(overlap, radius), 0.5 * std::sqrt(overlap * radius), 1e-12);
}

TEST(Heat, SphereOnAWallComesToItsTemperature) {
  Scene scene;
  scene.bed = {0.1, 0.1, 0.004, BedTop::open};
  scene.contacts.restitution = 0.9;
  heatOf(scene).temperature = 300.0;
  const double overlap = 2e-5, radius = scene.particles.diameter / 2.0;
  const double tau = particleHeatCapacity(scene) / (4.0 * 1.0 * std::sqrt(2.0 * radius * overlap));
  for (const bool adiabatic : {true, false}) {
    if (!adiabatic) heatOf(scene).wallTemperature = 400.0;
    WarmBed bed(scene, {{0.05, radius - overlap}});
    bed.findContacts();
    for (int i = 0; i < 10000; ++i) bed.heat->act(tau / 10000, tau / 10000);
    EXPECT_NEAR(bed.temperature[0], adiabatic ? 300.0 : 400.0 - 100.0 * std::exp(-1.0), 0.01);
  }
}

TEST(Heat, CollidingParticlesKeepTheirHeat) {
  Scene scene;
  scene.bed = {0.05, 0.05, 0.004, BedTop::lid};
  scene.contacts.restitution = 0.9;
  heatOf(scene).conductivity = 200.0;
  heatOf(scene).temperature = 300.0;
  heatOf(scene).tracerTemperature = 500.0;
  std::vector<Vec2> centres;
  for (int i = 0; i < 60; ++i)
    centres.push_back({0.003 + 0.0044 * (i % 10) + 0.001 * (i / 10 % 3), 0.003 + 0.005 * (i / 10)});
  WarmBed bed(scene, centres);
  const double before = bed.particleHeat();
  const auto spread = [&] {  // mean square
    double sum = 0.0;
    for (const double t : bed.temperature) sum += (t - 400.0) * (t - 400.0) / 60.0;
    return sum;
  };
  for (int i = 0; i < 4000; ++i) {
    ASSERT_FALSE(bed.solver->advance(5));
    bed.heat->act(5e-5, 5e-5);
  }
  EXPECT_NEAR(bed.particleHeat() / before, 1.0, 1e-13);
  EXPECT_LT(spread(), 0.99 * 100.0 * 100.0);
  EXPECT_GT(spread(), 1.0);
}

/// A bed that is blown through, with all that moves heat.
Scene blownScene() {
  Scene scene = lowScene(200, 3.0);
  heatOf(scene).temperature = 350.0;
  heatOf(scene).gas->temperature = 350.0;
  return scene;
}
std::vector<Vec2> loosePacking() {
  std::vector<Vec2> centres;
  for (int i = 0; i < 200; ++i)
    centres.push_back({0.0022 + 0.0043 * (i % 11) + 0.0002 * (i / 11 % 2), 0.0021 + 0.0041 * (i / 11)});
  return centres;
}

TEST(Heat, WhatIsEquallyWarmStaysSo) {
  Scene scene = blownScene();
  heatOf(scene).wallTemperature = 350.0;
  WarmBed bed(scene, loosePacking());
  for (int i = 0; i < 1000; ++i) bed.step();
  for (const double t : bed.temperature) EXPECT_NEAR(t, 350.0, 1e-9);
  for (const int c : bed.gas->layout().openCells) EXPECT_NEAR(bed.gasTemperature(c), 350.0, 1e-9);
}

TEST(Heat, NothingBecomesWarmerThanWhatWarmsIt) {
  Scene scene = blownScene();
  heatOf(scene).heatCapacity = 0.01;  // the exchange is far faster than a step
  heatOf(scene).conductivity = 0.0;
  heatOf(scene).gas->inletTemperature = 500.0;
  WarmBed bed(scene, loosePacking());
  for (int i = 0; i < 500; ++i) {
    bed.step();
    for (const double t : bed.temperature) ASSERT_TRUE(t >= 350.0 - 1e-9 && t <= 500.0 + 1e-9) << t;
  }
  const auto& t = bed.temperature;
  EXPECT_GT(*std::max_element(t.begin(), t.end()), 490.0);
}

TEST(Heat, WhatOnePhaseGivesTheOtherGets) {
  Scene scene = blownScene();
  heatOf(scene).tracerTemperature = 600.0;
  heatOf(scene).gas->inletTemperature = 300.0;
  WarmBed bed(scene, loosePacking());
  double before = bed.particleHeat() + bed.gasHeat(), largest = 0.0;
  const double start = bed.particleHeat();
  for (int i = 0; i < 1000; ++i) {
    bed.step();
    const double now = bed.particleHeat() + bed.gasHeat();
    largest = std::max(largest, std::abs(now - before - bed.inflow() * scene.gas->step));
    before = now;
  }
  EXPECT_LT(bed.particleHeat(), start * (1.0 - 1e-4));
  EXPECT_LT(largest, 1e-12 * start);
}

}  // namespace
}  // namespace bedmix::test
