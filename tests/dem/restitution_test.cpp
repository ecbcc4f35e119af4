// SPDX-License-Identifier: MIT
#include "tests/dem/integrators.h"
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

// The law is linear. A sphere that goes a tenth of a diameter in a step must be in the lists before it
// pushes, which verlet-onset has it do up to half a step before it touches.
TEST_P(Restitution, IsTheSameAtAnySpeed) {
  scene_.limits.maxOverlap = 0.5;
  scene_.time.step = contactTimeScale(scene_) / 20.0;
  const double d = scene_.particles.diameter;
  const auto rebound = [&](double way, double phase, bool atWall) {  // way and phase of a step, in diameters
    const double gap = (20.0 + phase) * way * d, speed = way * d / scene_.time.step;
    const auto solver = atWall ? solverAt(scene_, {{0.0, d / 2.0 + gap}}, wideFloor())
                               : solverAt(scene_, {{0.0, d + gap}, {0.0, 0.0}});
    solver->particles().velocity[0].y = -speed;
    EXPECT_FALSE(solver->advance(40));
    const Particles p = inOrderOfIds(solver->particles());
    return (atWall ? p.velocity[0].y : p.velocity[0].y - p.velocity[1].y) / speed;
  };
  for (const bool atWall : {false, true})
    for (const double phase : {0.13, 0.31, 0.47, 0.71, 0.89}) {
      const double slow = rebound(1e-3, phase, atWall);
      EXPECT_GT(slow, 0.8);
      for (const double way : {0.01, 0.04, 0.1}) EXPECT_NEAR(rebound(way, phase, atWall), slow, 1e-10) << way;
    }
}

INSTANTIATE_TEST_SUITE_P(Integrators, Restitution, eachIntegrator(), nameOfIntegrator);

}  // namespace
}  // namespace bedmix
