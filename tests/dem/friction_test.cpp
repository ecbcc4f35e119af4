// SPDX-License-Identifier: MIT
#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

using std::numbers::pi;

class Friction : public testing::TestWithParam<Integrator> {
 protected:
  Friction() {
    scene_.contacts.friction = FrictionSettings{};
    scene_.time.integrator = GetParam();
    scene_.time.step = 1e-6;
  }

  /// Throws one sphere at the floor, at vx along and vy (both m/s) down, and lets it rebound.
  Particles bounce(double vx, double vy) const {
    const auto solver = solverAt(scene_, {{0.0, scene_.particles.diameter / 2.0 + 1e-7}}, wideFloor());
    solver->particles().velocity[0].x = vx;
    solver->particles().velocity[0].y = -vy;
    EXPECT_FALSE(solver->advance(1000));
    EXPECT_EQ(solver->contactCount(), 0);
    return solver->particles();
  }

  Scene scene_ = smoothSpheres();
};

// A sphere that slides starts to roll at t = 2 v0/(7 mu g), at 5/7 of its speed.
TEST_P(Friction, SlidingTurnsIntoRolling) {
  scene_.gravity = 9.81;
  scene_.time.step = 1e-5;
  constexpr double start = 0.2;
  const double m = particleMass(scene_), mu = scene_.contacts.friction->coefficient;
  const double rollsAt = 2.0 * start / (7.0 * mu * scene_.gravity);
  const double sag = m * scene_.gravity / normalStiffness(scene_);
  const auto solver = solverAt(scene_, {{0.0, scene_.particles.diameter / 2.0 - sag}}, wideFloor());
  Particles& p = solver->particles();
  p.velocity[0].x = start;

  double firstRoll = 0.0;
  for (int s = 1; s <= 10000; ++s) {
    ASSERT_FALSE(solver->advance(1));
    if (firstRoll == 0.0 && p.velocity[0].x + p.spin[0] * p.radius <= 0.0) firstRoll = s * scene_.time.step;
    if (s == 1000) {
      EXPECT_NEAR(p.velocity[0].x, start - mu * scene_.gravity * 0.01, 2e-5);
    }
  }
  EXPECT_NEAR(firstRoll, rollsAt, 0.01 * rollsAt);
  EXPECT_NEAR(p.velocity[0].x, 5.0 / 7.0 * start, 1e-4 * start);
  EXPECT_NEAR(p.spin[0], -p.velocity[0].x / p.radius, 1e-4 * start / p.radius);
}

// In full sliding the tangential impulse is mu times that of |F_n|; without damping that is mu (1 + e) m v_n.
TEST_P(Friction, ObliqueImpactInFullSliding) {
  const double m = particleMass(scene_), r = scene_.particles.diameter / 2.0;
  constexpr double vx = 1.0, vy = 0.2;
  for (const double e : {1.0, 0.9}) {
    scene_.contacts.restitution = e;
    // The linear law pulls at the very end, from the moment of the largest rebound speed on.
    const DampedOscillator normal{m, normalStiffness(scene_), wallDamping(scene_), 0.0, vy};
    const double a = normal.decay(), w = normal.frequency();
    const double fastest = -normal.velocityAt((pi - std::atan2(2.0 * a * w, w * w - a * a)) / w);
    const double impulse = 0.3 * m * (vy * (1.0 - e) + 2.0 * fastest);
    const Particles p = bounce(vx, vy);
    EXPECT_NEAR(p.velocity[0].x, vx - impulse / m, 1e-3 * impulse / m) << "e = " << e;
    EXPECT_NEAR(p.spin[0], -impulse * r / p.inertia, 1e-3 * impulse * r / p.inertia) << "e = " << e;
    if (e == 1.0) {
      EXPECT_NEAR(impulse, 0.3 * 2.0 * m * vy, 1e-12 * m);
    }
  }
}

// With tangential constants 2/7 of the normal ones both directions swing alike: where it sticks, the surface
// velocity rebounds with the same restitution.
TEST_P(Friction, ObliqueImpactThatSticks) {
  const double r = scene_.particles.diameter / 2.0;
  constexpr double vx = 0.15, vy = 0.2;  // 2/7 vx/vy < mu
  const Particles p = bounce(vx, vy);
  const double expected = vx - 2.0 / 7.0 * 1.9 * vx;
  // Euler's slip is of first order, w dt = 6e-3 here.
  const double allowed = GetParam() == Integrator::symplecticEuler ? 6e-3 * vx : 1e-3 * vx;
  EXPECT_NEAR(p.velocity[0].x, expected, allowed);
  EXPECT_NEAR(p.velocity[0].x + r * p.spin[0], -0.9 * vx, 2.0 * allowed);
}

// Any other spring: half a normal period is a part of the tangential one, impulse m_t v (1 - cos(w_t t_c)).
TEST_P(Friction, ObliqueImpactWithAStifferTangentialSpring) {
  scene_.contacts.restitution = 1.0;
  scene_.contacts.friction = {.coefficient = 1000.0, .stiffnessRatio = 0.5, .dampingRatio = 0.0};
  constexpr double vx = 0.1, vy = 0.2;
  const double m = particleMass(scene_), movable = 2.0 / 7.0 * m;
  const double phase = pi * std::sqrt(0.5 * m / movable);
  const Particles p = bounce(vx, vy);
  EXPECT_NEAR(p.velocity[0].x, vx - movable / m * vx * (1.0 - std::cos(phase)), 2e-3 * vx);
}

// Within a contact that sticks the tangential spring and the spin show the orders of the integrators.
TEST_P(Friction, OrderWithinAContactThatSticks) {
  constexpr double overlap = 5e-5, down = 0.2, along = 0.1, time = 1.6e-4;
  scene_.contacts.friction = {.coefficient = 1000.0, .stiffnessRatio = 0.5, .dampingRatio = 0.5};
  const double m = particleMass(scene_), movable = 2.0 / 7.0 * m, r = scene_.particles.diameter / 2.0;
  const SpringDashpot law = wallLaw(scene_);
  const DampedOscillator exact{movable, law.tangentialStiffness, law.tangentialDamping, 0.0, along};
  const auto error = [&](int steps) {
    scene_.time.step = time / steps;
    const auto solver = solverAt(scene_, {{0.0, r - overlap}}, wideFloor());
    solver->particles().velocity[0].x = along;
    solver->particles().velocity[0].y = -down;
    EXPECT_FALSE(solver->advance(steps));
    EXPECT_EQ(solver->contactCount(), 1);
    return std::abs(solver->particles().velocity[0].x + r * solver->particles().spin[0] -
                    exact.velocityAt(time));
  };
  const double order = GetParam() == Integrator::rk4               ? 4.0
                       : GetParam() == Integrator::symplecticEuler ? 1.0
                                                                   : 2.0;
  for (const int steps : {8, 16}) {
    const double measured = std::log2(error(steps) / error(2 * steps));
    EXPECT_NEAR(measured, order, 0.15) << steps << " steps";
  }
}

// A pair is like a wall: half the relative slip each, and equal spins. Slow, so that the line of centres
// turns by only a thousandth while they touch.
TEST_P(Friction, ObliquePairThatSticks) {
  const auto solver = solverAt(scene_, {{0.0, 0.0}, {0.0, scene_.particles.diameter + 1e-8}});
  Particles& p = solver->particles();
  constexpr double vx = 0.015, vy = 0.02;
  p.velocity[1].x = vx / 2.0, p.velocity[0].x = -vx / 2.0;
  p.velocity[1].y = -vy / 2.0, p.velocity[0].y = vy / 2.0;
  ASSERT_FALSE(solver->advance(700));
  ASSERT_EQ(solver->contactCount(), 0);
  const Particles after = inOrderOfIds(p);
  EXPECT_NEAR(after.velocity[1].x, vx / 2.0 * (1.0 - 2.0 / 7.0 * 1.9), 1e-3 * vx);
  EXPECT_NEAR(after.velocity[0].x, -after.velocity[1].x, 1e-12);
  EXPECT_DOUBLE_EQ(after.spin[0], after.spin[1]);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Friction, eachIntegrator(), nameOfIntegrator);

}  // namespace
}  // namespace bedmix
