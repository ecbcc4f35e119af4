// SPDX-License-Identifier: MIT
#include "engine/core/bed_statistics.h"
#include "engine/simulation.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bedmix {
namespace {

double bedWeightPerArea(const Scene& scene) {
  return static_cast<double>(scene.particles.count) * particleMass(scene) * scene.gravity /
         (scene.bed.width * scene.bed.thickness);
}

TEST(Coupled, TerminalVelocityOfOneSphere) {
  // A duct so wide and deep that the voidage is 1; the gas rises a little faster than the sphere falls
  // through it.
  Scene scene = test::paperScene(12.6);
  scene.bed.width = 1.0;
  scene.bed.height = 20.0;
  scene.bed.thickness = 0.5;
  scene.gas->grid.columns = {{4, 0.25}};
  scene.gas->grid.rows = {{80, 0.25}};
  scene.gas->inlets = {{0.0, 1.0, 12.6, std::nullopt}};
  scene.gas->step = 1e-3;
  scene.time.step = 5e-5;
  scene.particles.count = 1;
  scene.start.arrangement = Arrangement::drop;
  Simulation simulation = test::simulate(scene);
  ASSERT_EQ(simulation.advance(100'000), std::nullopt);  // 5 s, 8 relaxation times

  const FramePtr frame = simulation.frame();
  const GasGrid grid = makeGasGrid(scene);
  const auto column = static_cast<int>(frame->position[0].x / 0.25),
             row = static_cast<int>(frame->position[0].y / 0.25);
  ASSERT_LT(row, 70);
  const double slip = frame->gas.velocity[grid.cell(column, row)].y - frame->velocity[0].y;
  // 1/8 pi d^2 C_D rho slip^2 = (rho_p - rho) g pi d^3/6 with C_D = 0.43, as Re > 1000.
  const double exact = std::sqrt(4.0 / 3.0 * (1500.0 - 1.205) * 9.81 * 0.004 / (0.43 * 1.205));
  EXPECT_NEAR(slip / exact, 1.0, 0.005);
}

TEST(Coupled, NoneOneOrTwoParticles) {
  for (std::int64_t count : {0, 1, 2}) {
    Scene scene = test::paperScene(2.6);
    scene.particles.count = count;
    Simulation simulation = test::simulate(scene);
    ASSERT_EQ(simulation.advance(2000), std::nullopt);
    const FramePtr frame = simulation.frame();
    EXPECT_EQ(frame->size(), static_cast<std::size_t>(count));
    for (float v : frame->gas.voidage) EXPECT_GT(v, 0.9f);
    EXPECT_LT(simulation.report().largestMassResidual, 1e-10);
  }
}

/// A low bed that strong gas lifts to the top at once.
Scene liftedScene(BedTop top) {
  Scene scene = test::lowScene(100, 6.0);
  scene.bed.top = top;
  scene.limits.maxOverlap = 0.3;
  return scene;
}

std::int64_t above(const Frame& frame, double height) {
  return std::count_if(frame.position.begin(), frame.position.end(), [&](Vec2f p) { return p.y > height; });
}

TEST(Coupled, OpenTopLetsParticlesRiseAndFallBack) {
  Simulation simulation = test::simulate(liftedScene(BedTop::open));
  std::int64_t risen = 0;
  for (int k = 0; k < 40; ++k) {
    ASSERT_EQ(simulation.advance(1000), std::nullopt);
    risen = std::max(risen, above(*simulation.frame(), 0.12));
  }
  EXPECT_GT(risen, 20);
  EXPECT_GE(simulation.report().aboveGridLargest, risen);
  simulation.setInlets({{0.0, 0.048, 0.0, std::nullopt}});
  ASSERT_EQ(simulation.advance(100'000), std::nullopt);
  EXPECT_EQ(above(*simulation.frame(), 0.12), 0);
  EXPECT_LT(simulation.report().largestMassResidual, 1e-10);
}

TEST(Coupled, LidHoldsParticlesAndLetsGasThrough) {
  Simulation simulation = test::simulate(liftedScene(BedTop::lid));
  for (int k = 0; k < 40; ++k) {
    ASSERT_EQ(simulation.advance(1000), std::nullopt);
    ASSERT_EQ(above(*simulation.frame(), 0.12), 0);
  }
  EXPECT_GT(above(*simulation.frame(), 0.06), 50);  // the gas holds most of them up there
  EXPECT_LT(simulation.report().largestMassResidual, 1e-10);
}

TEST(Coupled, MinimumFluidizationOnASlowRamp) {
  Scene scene = test::paperScene(0.8);
  scene.bed.width = 0.048;
  scene.gas->grid.columns = {{4, 0.012}};
  scene.particles.count = 350;
  Simulation simulation = test::simulate(scene);
  const GasGrid grid = makeGasGrid(scene);

  // Voidage of the resting bed, from the rows that lie wholly inside it.
  const FramePtr rest = simulation.frame();
  const auto fullRows = static_cast<int>((bedHeight(*rest, scene) - 2 * scene.particles.diameter) / 0.012);
  double voidage = 0.0;
  for (int r = 0; r < fullRows; ++r)
    for (int c = 0; c < grid.columns; ++c)
      voidage += static_cast<double>(rest->gas.voidage[grid.cell(c, r)]) / (fullRows * grid.columns);

  // Ergun's root: the pressure gradient carries the weight.
  const double mu = scene.gas->viscosity, rho = scene.gas->density, d = scene.particles.diameter;
  const double e3 = voidage * voidage * voidage, solids = 1.0 - voidage;
  const double a = 1.75 * rho * solids / (e3 * d), b = 150 * solids * solids * mu / (e3 * d * d);
  const double c = solids * (1500.0 - rho) * 9.81;
  const double ergun = (-b + std::sqrt(b * b + 4 * a * c)) / (2 * a);

  // 0.5 m/s per s: the first velocity at which the pressure drop carries the weight of the bed above the
  // level where it is taken, the centre of the lowest cells, but for 2 %.
  const double carried = bedWeightPerArea(scene) * (1.0 - 0.006 / bedHeight(*rest, scene));
  double fluidized = 0.0;
  for (double u = 0.8; u < 2.0 && fluidized == 0.0; u += 0.005) {
    simulation.setInlets({{0.0, scene.bed.width, u, std::nullopt}});
    ASSERT_EQ(simulation.advance(1000), std::nullopt);
    if (pressureDrop(*simulation.frame(), grid) >= 0.98 * carried) fluidized = u;
  }
  RecordProperty("ergun", std::to_string(ergun));
  RecordProperty("measured", std::to_string(fluidized));
  EXPECT_NEAR(fluidized / ergun, 1.0, 0.10) << "voidage " << voidage << ", Ergun " << ergun;
}

TEST(Coupled, PressureDropCarriesTheBedAtTwiceMinimumFluidization) {
  Scene scene = test::paperScene(0.0);
  scene.gas->inlets = {{0.0, scene.bed.width, std::nullopt, 2.0}};
  scene.limits.maxOverlap = 0.3;
  Simulation simulation = test::simulate(scene);
  const GasGrid grid = makeGasGrid(scene);
  ASSERT_EQ(simulation.advance(100'000), std::nullopt);  // 1 s: the first plug has come down
  double lowestCells = 0.0, floor = 0.0;
  const int samples = 400;
  for (int k = 0; k < samples; ++k) {
    ASSERT_EQ(simulation.advance(1000), std::nullopt);
    const FramePtr frame = simulation.frame();
    lowestCells += pressureDrop(*frame, grid) / samples;
    for (int c = 0; c < grid.columns; ++c) {
      const double lowest = frame->gas.pressure[grid.cell(c, 0)], next = frame->gas.pressure[grid.cell(c, 1)];
      floor += (lowest + 0.5 * (lowest - next)) / (samples * grid.columns);
    }
  }
  // Taken at the centres of the lowest cells, the drop lacks the 6 mm of bed below them; carried on to the
  // floor it does not. The rest of the weight stands on the floor whenever particles come down.
  EXPECT_NEAR(lowestCells / bedWeightPerArea(scene), 1.0, 0.05);
  EXPECT_NEAR(floor / bedWeightPerArea(scene), 1.0, 0.03);
  RecordProperty("lowest_cells", std::to_string(lowestCells / bedWeightPerArea(scene)));
  RecordProperty("floor", std::to_string(floor / bedWeightPerArea(scene)));
  EXPECT_LT(simulation.report().largestMassResidual, 1e-10);
}

TEST(Coupled, ProjectionHoldsSimplesResult) {
  // 10 ms into the lift, before chaos amplifies any difference: what the two schemes differ by must be far
  // below what either gains from half the gas step, and shrink with that step.
  const auto liftedBed = [](GasScheme scheme, double gasStep) {
    Scene scene = test::paperScene(2.6);
    scene.particles.count = 400;
    scene.bed.width = 0.048;
    scene.gas->grid.columns = {{4, 0.012}};
    scene.gas->inlets = {{0.0, 0.048, 2.6, std::nullopt}};
    scene.gas->scheme = scheme;
    scene.gas->step = gasStep;
    Simulation simulation = test::simulate(scene);
    EXPECT_EQ(simulation.advance(1000), std::nullopt);
    EXPECT_EQ(simulation.report().gasStepsNotConverged, 0);
    return simulation.frame();
  };
  const auto distance = [](const Frame& a, const Frame& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(norm(a.position[i] - b.position[i]), 2.0);
    return std::sqrt(squares / static_cast<double>(a.size())) / 0.004;
  };
  const FramePtr projected = liftedBed(GasScheme::projection, 1e-4),
                 finer = liftedBed(GasScheme::projection, 5e-5);
  const double coarse = distance(*projected, *liftedBed(GasScheme::simple, 1e-4));
  const double fine = distance(*finer, *liftedBed(GasScheme::simple, 5e-5));
  const double stepError = distance(*projected, *finer);
  EXPECT_LT(coarse, 0.01 * stepError);
  EXPECT_LT(fine, 0.7 * coarse);
}

}  // namespace
}  // namespace bedmix
