// SPDX-License-Identifier: MIT
#include "engine/core/walls.h"
#include "engine/dem/particle_step.h"
#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

using std::numbers::pi;

/// One hard and inelastic sphere on a floor that moves with so many times the acceleration of gravity.
class Vibration : public testing::TestWithParam<Integrator> {
 protected:
  static constexpr double frequency = 20.0;  // Hz

  Vibration() {
    scene_.gravity = 9.81;
    scene_.bed.width = 0.02;
    scene_.contacts.stiffness = 2e4;
    scene_.contacts.restitution = 0.05;
    scene_.time.integrator = GetParam();
    scene_.time.step = 1e-6;
  }

  double amplitude(double times) const { return times * scene_.gravity / std::pow(2.0 * pi * frequency, 2); }
  std::unique_ptr<ParticleSolver> solver(double times) {
    scene_.floor.vibration = VibrationSettings{amplitude(times), frequency};
    const double sag = particleMass(scene_) * scene_.gravity / scene_.contacts.stiffness;
    auto made = solverAt(scene_, {{0.01, scene_.particles.diameter / 2.0 - sag}}, bedWalls(scene_));
    made->particles().velocity[0].y = 2.0 * pi * frequency * amplitude(times);
    return made;
  }

  Scene scene_ = smoothSpheres();
};

TEST_P(Vibration, FloorCarriesASphereBelowGravity) {
  const auto solver = this->solver(0.9);
  for (int k = 1; k <= 100; ++k) {
    ASSERT_FALSE(solver->advance(1000));
    ASSERT_EQ(solver->contactCount(), 1) << k;
    const double floor = amplitude(0.9) * std::sin(2.0 * pi * frequency * 1e-3 * k);
    EXPECT_NEAR(solver->particles().position[0].y - 0.002, floor, 2e-3 * amplitude(0.9)) << k;
  }
}

// It leaves the floor where that falls as fast as it: A w^2 sin(w t) = g.
TEST_P(Vibration, SphereLiftsOffWhereTheFloorFallsFaster) {
  const auto solver = this->solver(1.5);
  const double expected = std::asin(1.0 / 1.5) / (2.0 * pi * frequency);
  double left = 0.0;
  for (int k = 1; k <= 1000 && left == 0.0; ++k) {
    ASSERT_FALSE(solver->advance(50));
    if (solver->contactCount() == 0) left = 50e-6 * k;
  }
  EXPECT_NEAR(left, expected, 0.01 / frequency);
  // Then it flies from there with the floor's velocity.
  ASSERT_FALSE(solver->advance(2000));
  const double phase = 2.0 * pi * frequency * expected, gone = left + 2e-3 - expected;
  const double height = amplitude(1.5) * std::sin(phase) +
                        amplitude(1.5) * 2.0 * pi * frequency * std::cos(phase) * gone -
                        0.5 * scene_.gravity * gone * gone;
  EXPECT_NEAR(solver->particles().position[0].y - 0.002, height, 0.01 * amplitude(1.5));
}

// Thrown at a floor that comes up: relative to it the speed turns round times the restitution.
TEST_P(Vibration, FloorHitsWithItsVelocity) {
  scene_.gravity = 0.0;
  scene_.contacts.restitution = 0.8;
  scene_.floor.vibration = VibrationSettings{1e-3, frequency};
  const auto solver = solverAt(scene_, {{0.01, 0.002 + 2e-5}}, bedWalls(scene_));
  solver->particles().velocity[0].y = -0.1;
  for (int k = 0; k < 100; ++k) ASSERT_FALSE(solver->advance(10));
  EXPECT_EQ(solver->contactCount(), 0);
  const double floor = 2.0 * pi * frequency * 1e-3;
  EXPECT_NEAR(solver->particles().velocity[0].y, floor + 0.8 * (0.1 + floor), 0.01 * floor);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Vibration, eachIntegrator(), nameOfIntegrator);

TEST(VibrationSteps, ChosenOnesKeepTheSameTime) {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  scene.bed.width = 0.02;
  scene.contacts.restitution = 0.8;
  scene.time.step = StepLength::automatic();
  scene.time.integrator = Integrator::verletOnset;
  scene.floor.vibration = VibrationSettings{1e-3, 25.0};
  const auto run = [&](double error) {
    scene.time.error = error;
    const auto solver = solverAt(scene, {{0.01, 0.004}}, bedWalls(scene));
    ParticleStep step(scene);
    for (int k = 0; k < 10; ++k) {
      solver->setTime(0.01 * k);
      EXPECT_FALSE(step.advance(0.01, *solver).trouble);
    }
    return solver->particles().position[0].y;
  };
  EXPECT_NEAR(run(1e-3), run(1e-4), 3e-5);
}

}  // namespace
}  // namespace bedmix
