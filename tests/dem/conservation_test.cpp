// SPDX-License-Identifier: MIT
#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bedmix {
namespace {

/// Spheres on a square lattice in a box, each with a velocity of its own.
std::unique_ptr<ParticleSolver> crowd(const Scene& scene, int side, double spacing, double speed,
                                      const std::vector<WallSegment>& walls) {
  std::vector<Vec2> positions;
  for (int i = 0; i < side * side; ++i)
    positions.push_back({spacing * (0.5 + i % side), spacing * (0.5 + i / side)});
  auto solver = solverAt(scene, positions, walls);
  Particles& p = solver->particles();
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.velocity[i].x = speed * std::sin(2.3 * static_cast<double>(i) + 0.4);
    p.velocity[i].y = speed * std::cos(1.7 * static_cast<double>(i));
  }
  return solver;
}

double energy(const ParticleSolver& solver) {
  return solver.kineticEnergy() + solver.elasticEnergy() + solver.potentialEnergy();
}

/// Largest relative departure of the energy from its start.
double energyDrift(ParticleSolver& solver, int pieces, std::int64_t steps) {
  const double start = energy(solver);
  double largest = 0.0;
  for (int i = 0; i < pieces; ++i) {
    EXPECT_FALSE(solver.advance(steps / pieces));
    largest = std::max(largest, std::abs(energy(solver) / start - 1.0));
  }
  return largest;
}

class Conservation : public testing::TestWithParam<Integrator> {
 protected:
  Conservation() {
    scene_.contacts.restitution = 1.0;
    scene_.time.integrator = GetParam();
  }
  Scene scene_ = smoothSpheres();
};

// Two spheres squeezed between two walls never part: two modes of a chain of three equal springs, k/m and 3
// k/m. Verlet's energy is bounded; that of Runge and Kutta decays by (w dt)^6/72 a step, as its amplification
// tells.
TEST_P(Conservation, EnergyOfASqueezedPairOverAMillionSteps) {
  constexpr double speed = 0.3;
  constexpr int pieces = 1000, steps = 1000;
  const auto solver = solverAt(scene_, {{0.0019, 0.01}, {0.0058, 0.01}}, closedBox(0.0077, 0.02));
  solver->particles().velocity[0].x = speed;
  ASSERT_FALSE(solver->advance(0));
  const double m = particleMass(scene_), k = normalStiffness(scene_), dt = scene_.time.step;
  const double perMode = 0.25 * m * speed * speed, start = energy(*solver);
  std::vector<double> change;  // of the energy over that of the motion
  for (int i = 0; i < pieces; ++i) {
    ASSERT_FALSE(solver->advance(steps));
    change.push_back((energy(*solver) - start) / (2.0 * perMode));
  }
  EXPECT_EQ(solver->contactCount(), 3);
  if (GetParam() == Integrator::rk4) {
    const auto left = [&](double w2) { return std::exp(-1e6 * std::pow(w2 * dt * dt, 3.0) / 72.0); };
    const double expected = 0.5 * (left(k / m) + left(3.0 * k / m)) - 1.0;
    EXPECT_NEAR(change.back(), expected, 0.01 * std::abs(expected));
  } else {
    const auto [lowest, highest] = std::minmax_element(change.begin(), change.begin() + pieces / 2);
    const auto [low, high] = std::minmax_element(change.begin() + pieces / 2, change.end());
    // Verlet's swings are of second order, Euler's of first.
    const double angle = std::sqrt(3.0 * k / m) * dt;
    EXPECT_LT(*highest - *lowest, GetParam() == Integrator::symplecticEuler ? angle : 0.75 * angle * angle);
    EXPECT_NEAR(*high, *highest, 0.1 * (*highest - *lowest));
    EXPECT_NEAR(*low, *lowest, 0.1 * (*highest - *lowest));
  }
}

// Free flight between collisions: each leaves a small random error that depends on where in a step it begins.
TEST_P(Conservation, EnergyOfABouncingPairOverAMillionSteps) {
  const auto drift = [&](double step, std::int64_t steps) {
    scene_.time.step = step;
    const auto solver = solverAt(scene_, {{0.0061, 0.01}, {0.0152, 0.01}}, closedBox(0.02, 0.02));
    solver->particles().velocity[0].x = 0.3;
    solver->particles().velocity[1].x = -0.11;
    return energyDrift(*solver, 1000, steps);
  };
  const double coarse = drift(1e-5, 250000), fine = drift(2.5e-6, 1000000);
  RecordProperty("drift_at_10us", std::to_string(coarse));
  RecordProperty("drift_at_2.5us", std::to_string(fine));
  // Euler's energy also swings by w dt/2 as long as they touch.
  EXPECT_LT(coarse, GetParam() == Integrator::symplecticEuler ? 0.06 : 0.02);
  EXPECT_LT(fine, coarse / 4.0);
}

TEST_P(Conservation, EnergyOfAnElasticCrowd) {
  scene_.gravity = 9.81;
  const auto solver = crowd(scene_, 6, 0.006, 0.5, closedBox(0.036, 0.036));
  const double drift = energyDrift(*solver, 100, 100000);
  RecordProperty("drift", std::to_string(drift));
  EXPECT_LT(drift, 5e-3);
  EXPECT_GT(solver->neighbourBuilds(), 100);
}

TEST_P(Conservation, MomentumOfAFreeCrowdToRoundOff) {
  scene_.contacts.restitution = 0.9;
  scene_.contacts.friction = FrictionSettings{};
  const auto solver = crowd(scene_, 8, 0.0041, 0.3, {});
  const Particles& p = solver->particles();
  const auto momentum = [&] {
    Vec2 sum;
    for (std::size_t i = 0; i < p.size(); ++i) sum += p.mass * p.velocity[i];
    return sum;
  };
  const Vec2 before = momentum();
  const double kinetic = solver->kineticEnergy();
  ASSERT_FALSE(solver->advance(5000));
  EXPECT_LT(solver->kineticEnergy(), 0.9 * kinetic);  // they did collide
  EXPECT_NEAR(momentum().x, before.x, 1e-13 * p.mass * 64.0);
  EXPECT_NEAR(momentum().y, before.y, 1e-13 * p.mass * 64.0);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Conservation, eachIntegrator(), nameOfIntegrator);

}  // namespace
}  // namespace bedmix
