// SPDX-License-Identifier: MIT
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bedmix {
namespace {

/// Lets `count` spheres stacked on the floor come to rest and compares every overlap with the weight above
/// it.
void expectStackAtRest(Integrator integrator, int count, double seconds) {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  scene.time.integrator = integrator;
  const double d = scene.particles.diameter, weight = particleMass(scene) * scene.gravity;
  std::vector<Vec2> positions;
  for (int i = 0; i < count; ++i) positions.push_back({0.0, (0.5 + i) * d});
  const auto solver = solverAt(scene, positions, wideFloor());
  ASSERT_FALSE(solver->advance(std::llround(seconds / scene.time.step)));
  const Particles p = inOrderOfIds(solver->particles());
  const double sag = weight / normalStiffness(scene);
  for (int i = 0; i < count; ++i) {
    const double below = i == 0 ? -d / 2.0 : p.position[i - 1].y;
    EXPECT_NEAR(d - (p.position[i].y - below), (count - i) * sag, 1e-6 * sag) << "particle " << i;
    EXPECT_NEAR(p.velocity[i].y, 0.0, 1e-9);
  }
  EXPECT_EQ(solver->contactCount(), count);
}

TEST(Rest, TwoOnTheFloor) {
  expectStackAtRest(Integrator::velocityVerlet, 2, 1.0);
  expectStackAtRest(Integrator::rk4, 2, 1.0);
}

TEST(Rest, TenOnTheFloor) { expectStackAtRest(Integrator::velocityVerlet, 10, 8.0); }

// On an incline below the angle of friction a sphere without torque would stay; a free one rolls down with
// 5/7 g sin(alpha).
TEST(Rest, SphereRollsDownAnIncline) {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  scene.contacts.friction = FrictionSettings{};
  const double slope = 0.2;  // rad; rolls without sliding as tan(0.2) < 7/2 mu
  const Vec2 down{-std::cos(slope), -std::sin(slope)}, up{-std::sin(slope), std::cos(slope)};
  const double r = scene.particles.diameter / 2.0;
  const double sag = particleMass(scene) * scene.gravity * std::cos(slope) / normalStiffness(scene);
  const auto solver = solverAt(scene, {(r - sag) * up}, {{2.0 * down, -2.0 * down}});
  ASSERT_FALSE(solver->advance(20000));
  const Particles& p = solver->particles();
  const double speed = dot(p.velocity[0], down);
  const double expected = 5.0 / 7.0 * scene.gravity * std::sin(slope) * 0.2;
  EXPECT_NEAR(speed, expected, 1e-3 * expected);
  EXPECT_NEAR(p.spin[0], speed / r, 1e-3 * expected / r);
}

}  // namespace
}  // namespace bedmix
