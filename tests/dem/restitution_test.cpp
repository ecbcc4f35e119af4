// SPDX-License-Identifier: MIT
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace bedmix {
namespace {

using std::numbers::pi;

// exp(-pi zeta / sqrt(1 - zeta^2)), the rebound of a linear spring and dashpot that part at zero overlap.
double exactRestitution(double stiffness, double damping, double mass) {
  const double zeta = damping / (2.0 * std::sqrt(stiffness * mass));
  return std::exp(-pi * zeta / std::sqrt(1.0 - zeta * zeta));
}

/// Two spheres that fly at each other along a tilted line, `gap` (m) apart, each at half of `speed` (m/s).
std::unique_ptr<ParticleSolver> headOn(const Scene& scene, double gap, double speed) {
  const double distance = scene.particles.diameter + gap;
  const Vec2 along{0.6, 0.8};
  auto solver = solverAt(scene, {{0.0, 0.0}, distance * along});
  Particles& p = solver->particles();
  p.velocity = {0.5 * speed * along, -0.5 * speed * along};
  return solver;
}

/// Speed at which the two part, m/s; negative while they approach.
double parting(const Particles& p) {
  const Vec2 apart = p.position[1] - p.position[0];
  return dot(apart, p.velocity[1] - p.velocity[0]) / norm(apart);
}

double pairRebound(const Scene& scene, double gap) {
  constexpr double speed = 0.2;
  const auto solver = headOn(scene, gap, speed);
  EXPECT_FALSE(solver->advance(std::llround(0.003 / scene.time.step)));
  return parting(solver->particles()) / speed;
}

double wallRebound(const Scene& scene, double gap) {
  constexpr double speed = 0.2;
  const auto solver = solverAt(scene, {{0.0, scene.particles.diameter / 2.0 + gap}}, wideFloor());
  solver->particles().velocity[0].y = -speed;
  EXPECT_FALSE(solver->advance(std::llround(0.003 / scene.time.step)));
  return solver->particles().velocity[0].y / speed;
}

class Restitution : public testing::TestWithParam<Integrator> {
 protected:
  Restitution() { scene_.time.integrator = GetParam(); }

  Scene scene_ = smoothSpheres();
};

TEST_P(Restitution, FromRestitutionPairAndWallRebound) {
  scene_.time.step = 1e-6;
  EXPECT_NEAR(pairRebound(scene_, 3.3e-6), 0.9, 5e-4);
  EXPECT_NEAR(wallRebound(scene_, 3.3e-6), 0.9, 5e-4);
}

TEST_P(Restitution, FromDampingPairAndWallReboundDiffer) {
  scene_.time.step = 1e-6;
  scene_.contacts.restitution.reset();
  scene_.contacts.damping = 0.17;
  const double m = particleMass(scene_);
  const double pair = exactRestitution(2000.0, 0.17, m / 2.0), wall = exactRestitution(2000.0, 0.17, m);
  EXPECT_NEAR(pair, 0.276, 5e-4);
  EXPECT_NEAR(wall, 0.417, 5e-4);
  EXPECT_NEAR(pairRebound(scene_, 3.3e-6), pair, 2e-3);
  EXPECT_NEAR(wallRebound(scene_, 3.3e-6), wall, 2e-3);
}

TEST_P(Restitution, ContactLastsHalfAPeriod) {
  scene_.time.step = 1e-6;
  const auto solver = headOn(scene_, 1e-7, 0.2);
  std::int64_t touching = 0;
  for (int s = 0; s < 2000; ++s) {
    ASSERT_FALSE(solver->advance(1));
    touching += solver->contactCount();
  }
  const DampedOscillator contact{particleMass(scene_) / 2.0, 2000.0, pairDamping(scene_), 0.0, 0.2};
  EXPECT_NEAR(static_cast<double>(touching) * scene_.time.step, pi / contact.frequency(), 2e-6);
}

// Within a contact the forces are smooth, and the integrators show their orders.
TEST_P(Restitution, OrderWithinAContact) {
  constexpr double overlap = 5e-5, speed = 0.2, time = 1.6e-4;
  const DampedOscillator exact{particleMass(scene_) / 2.0, 2000.0, pairDamping(scene_), overlap, speed};
  const auto error = [&](int steps) {
    scene_.time.step = time / steps;
    const auto solver = headOn(scene_, -overlap, speed);
    EXPECT_FALSE(solver->advance(steps));
    EXPECT_EQ(solver->contactCount(), 1);
    const Particles& p = solver->particles();
    const double depth = scene_.particles.diameter - norm(p.position[1] - p.position[0]);
    return std::max(std::abs(depth - exact.displacementAt(time)) * exact.frequency(),
                    std::abs(-parting(solver->particles()) - exact.velocityAt(time)));
  };
  const double order = GetParam() == Integrator::rk4 ? 4.0 : 2.0;
  for (const int steps : {8, 16}) {
    const double measured = std::log2(error(steps) / error(2 * steps));
    EXPECT_NEAR(measured, order, 0.1) << steps << " steps";
  }
}

// Root mean square error of the restitution over the phases of a step at which collisions begin and end; the
// steps differ a little from each other so that both phases take all values.
double reboundError(Scene scene, double step) {
  constexpr int collisions = 200;
  double sum = 0.0;
  for (int c = 0; c < collisions; ++c) {
    const double begin = std::fmod(0.6180339887 * c, 1.0), end = (c + 0.5) / collisions;
    scene.time.step = step * (0.9 + 0.2 * end);
    const double e = pairRebound(scene, 0.2 * scene.time.step * begin + 1e-12);
    sum += (e - 0.9) * (e - 0.9);
  }
  return std::sqrt(sum / collisions);
}

// Contacts begin and end inside a step, where the dashpot's force jumps: a whole collision is of first order
// with either integrator.
TEST_P(Restitution, OrderOverAWholeCollision) {
  const double coarse = reboundError(scene_, 1e-5), middle = reboundError(scene_, 2.5e-6);
  const double fine = reboundError(scene_, 6.25e-7);
  RecordProperty("rms_error_at_10us", std::to_string(coarse));
  EXPECT_NEAR(0.5 * std::log2(coarse / middle), 1.0, 0.1);
  EXPECT_NEAR(0.5 * std::log2(middle / fine), 1.0, 0.1);
  EXPECT_LT(coarse, 0.003);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Restitution,
                         testing::Values(Integrator::velocityVerlet, Integrator::rk4), [](const auto& tried) {
                           return tried.param == Integrator::rk4 ? "rk4" : "velocityVerlet";
                         });

}  // namespace
}  // namespace bedmix
