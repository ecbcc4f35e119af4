// SPDX-License-Identifier: MIT
#include "engine/coupling/drag_laws.h"
#include "engine/dem/particle_solver.h"
#include "tests/gas/gas_scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bedmix {
namespace {

/// One sphere in gas that rises evenly, voidage 1: the drag coefficient is evaluated once a gas step, as
/// Exchange does, and acts within the particle's steps.
class Sphere {
 public:
  Sphere(const Scene& scene, double gasVelocity) : scene_(scene), gas_(gasVelocity) {
    Particles start = makeParticles(scene, {{0.05, 0.2}});
    start.addExternalForces();
    solver_ = ParticleSolver::make(scene, std::move(start), {});
  }

  double slip() const { return gas_ - solver_->particles().velocity[0].y; }
  /// B, kg/s.
  double drag() const {
    const DragProperties air{scene_.particles.diameter, scene_.gas->density, scene_.gas->viscosity};
    const double voidage = 1.0, size = std::abs(slip());
    double perVolume = 0.0;
    evaluateDragLaw(DragLaw::wenYu, air, 1, &voidage, &size, &perVolume);
    return particleVolume(scene_) * perVolume;
  }
  void gasStep() {
    Particles& p = solver_->particles();
    p.drag[0] = drag();
    p.external[0] = {0.0, p.drag[0] * gas_};
    EXPECT_FALSE(solver_->advance(stepsPerGasStep(scene_)));
  }

 private:
  Scene scene_;
  double gas_;
  std::unique_ptr<ParticleSolver> solver_;
};

/// A sphere of the paper's size without weight.
Scene sphereScene(double density, double gasStep) {
  Scene scene = test::paperScene(0.0);
  scene.gravity = 0.0;
  scene.particles.density = density;
  scene.time.step = 1e-5;
  scene.gas->step = gasStep;
  return scene;
}

/// Largest relative error of the slip as it halves from 12 m/s: above Re 1000, drag is k slip^2 and
/// slip = s0 / (1 + s0 k t / m).
double slowingError(double density, double gasStep) {
  const Scene scene = sphereScene(density, gasStep);
  Sphere sphere(scene, 12.0);
  const double rate = sphere.drag() / particleMass(scene);  // s0 k / m
  double error = 0.0;
  for (int step = 1; step * gasStep < 1.0 / rate; ++step) {
    sphere.gasStep();
    error = std::max(error, std::abs(sphere.slip() * (1.0 + rate * step * gasStep) / 12.0 - 1.0));
  }
  return error;
}

TEST(Relaxation, DragOnceAGasStepIsFirstOrderAndSmallForThePapersSphere) {
  const double once = slowingError(1500.0, 1e-4), always = slowingError(1500.0, 1e-5);
  EXPECT_LT(once, 2e-5);
  EXPECT_NEAR(once / always, 10.0, 1.0);
  RecordProperty("once_a_gas_step", fmt::format("{:.2g}", once));
  RecordProperty("at_each_particle_step", fmt::format("{:.2g}", always));
}

TEST(Relaxation, LightSpheresSlowDownToFirstOrder) {
  double before = slowingError(2.0, 1e-4);  // 0.06 of the time in which the slip halves
  EXPECT_LT(before, 0.011);
  for (double gasStep : {2e-4, 4e-4, 8e-4}) {
    const double error = slowingError(2.0, gasStep);
    EXPECT_NEAR(error / before, 2.0, 0.25);
    before = error;
  }
}

TEST(Relaxation, StiffDragNeitherOvershootsNorMissesTheTerminalSlip) {
  // 20 um, thrown into the gas at 0.5 m/s: Stokes's relaxation time is 1.8 ms, a tenth of the gas step.
  Scene scene = sphereScene(1500.0, 2e-2);
  scene.particles.diameter = 2e-5;
  scene.gravity = 9.81;
  const double d = scene.particles.diameter;
  const double stokes = scene.particles.density * d * d / (18.0 * scene.gas->viscosity) * scene.gravity;
  Sphere sphere(scene, 0.5);
  ASSERT_GT(sphere.drag() * scene.gas->step / particleMass(scene), 10.0);
  for (int step = 0; step < 10; ++step) {
    sphere.gasStep();
    // The first step's coefficient is still that of the fast sphere.
    EXPECT_NEAR(sphere.slip() / stokes, 1.0, step == 0 ? 0.15 : 0.02);
  }
  EXPECT_NEAR(sphere.drag() * sphere.slip() / (particleMass(scene) * scene.gravity), 1.0, 1e-9);
}

}  // namespace
}  // namespace bedmix
