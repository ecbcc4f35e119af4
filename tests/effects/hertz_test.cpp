// SPDX-License-Identifier: MIT
#include "engine/core/particle_list.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bedmix {
namespace {

Scene hertzian(double restitution) {
  Scene scene = smoothSpheres();
  scene.contacts.stiffness.reset();
  scene.contacts.hertz = HertzSettings{.youngsModulus = 5e6, .poissonRatio = 0.3};
  scene.contacts.restitution = restitution;
  scene.limits.warnOverlap = 0.05;
  scene.limits.maxOverlap = 0.5;
  scene.time.step = 1e-6;
  return scene;
}

struct Impact {
  double deepest, duration, rebound;  // m, s, of the approach
};

/// Of two spheres, or of one and a floor, at `speed`, m/s.
Impact impact(const Scene& scene, double speed, bool atFloor) {
  const double r = 0.5 * scene.particles.diameter;
  const auto solver = atFloor ? solverAt(scene, {{0.0, r + 1e-7}}, wideFloor())
                              : solverAt(scene, {{0.0, 2.0 * r + 1e-7}, {0.0, 0.0}});
  solver->particles().velocity[0].y = -speed;
  double touching = 0.0;
  for (int step = 0; step < 20000; ++step) {
    EXPECT_FALSE(solver->advance(1));
    if (solver->contactCount() > 0) touching += scene.time.step;
    if (touching > 0.0 && solver->contactCount() == 0) break;
  }
  const Particles p = inOrderOfIds(solver->particles());
  const double parting = atFloor ? p.velocity[0].y : p.velocity[0].y - p.velocity[1].y;
  return {solver->largestOverlap() * 2.0 * r, touching, parting / speed};
}

/// Hertz (1882): deepest overlap (15 m v^2/(16 E* sqrt R))^(2/5), contact 2.9433 of it over v.
TEST(Hertz, ElasticImpactIsThatOfHertz) {
  const Scene scene = hertzian(1.0);
  const double modulus = 5e6 / (2.0 * (1.0 - 0.09)), r = 0.002;
  for (const bool atFloor : {false, true}) {
    const double mass = particleMass(scene) * (atFloor ? 1.0 : 0.5), radius = atFloor ? r : r / 2.0;
    for (const double speed : {0.05, 0.5}) {
      const double deepest =
          std::pow(15.0 * mass * speed * speed / (16.0 * modulus * std::sqrt(radius)), 0.4);
      const Impact got = impact(scene, speed, atFloor);
      EXPECT_NEAR(got.deepest / deepest, 1.0, 1e-3) << speed;
      EXPECT_NEAR(got.duration / (2.9432750 * deepest / speed), 1.0, 5e-3) << speed;
      EXPECT_NEAR(got.rebound, 1.0, 1e-3) << speed;
    }
  }
}

/// Antypov & Elliott (2011): the same restitution at every speed, as long as the contact may pull at its end.
TEST(Hertz, RestitutionIsTheScenesAtAnySpeed) {
  for (const double e : {0.3, 0.6, 0.9})
    for (const double speed : {0.05, 0.5})
      for (const bool atFloor : {false, true})
        EXPECT_NEAR(impact(hertzian(e), speed, atFloor).rebound, e, 0.01) << e << ' ' << speed;
}

/// At rest on the floor it sinks in until 4/3 E* sqrt(R) d^1.5 bears its weight.
TEST(Hertz, WeightIsBorneAtHertzsOverlap) {
  Scene scene = hertzian(0.3);
  scene.gravity = 9.81;
  const double r = 0.002, modulus = 5e6 / (2.0 * (1.0 - 0.09));
  const double sag = std::pow(particleMass(scene) * 9.81 / (4.0 / 3.0 * modulus * std::sqrt(r)), 2.0 / 3.0);
  const auto solver = solverAt(scene, {{0.0, r - 0.5 * sag}}, wideFloor());
  ASSERT_FALSE(solver->advance(200000));
  EXPECT_NEAR((r - solver->particles().position[0].y) / sag, 1.0, 1e-3);
}

/// Mindlin (1949): stuck, a small slip x gives 8 G* sqrt(R d) x: a sphere swings along the floor with
/// w^2 = 8 G* sqrt(R d) / (2/7 m).
TEST(Hertz, TangentialSpringIsMindlins) {
  Scene scene = hertzian(1.0);
  scene.contacts.friction = FrictionSettings{.coefficient = 1000.0, .dampingRatio = 0.0};
  scene.time.step = 2e-7;
  const double r = 0.002, overlap = 2e-5, nu = 0.3, shear = 5e6 / (2.0 * (1.0 + nu));
  const double effective = shear / (2.0 * (2.0 - nu)), m = particleMass(scene);
  const double w = std::sqrt(8.0 * effective * std::sqrt(r * overlap) / (2.0 / 7.0 * m));
  // Held at its overlap by a constant force.
  const auto solver = solverAt(scene, {{0.0, r - overlap}}, wideFloor());
  Particles& p = solver->particles();
  const double modulus = 5e6 / (2.0 * (1.0 - nu * nu));
  p.addExternalForces();
  p.external[0] = {0.0, -4.0 / 3.0 * modulus * std::sqrt(r) * std::pow(overlap, 1.5)};
  p.velocity[0].x = 1e-4;
  const double time = 0.25 * 2.0 * std::acos(-1.0) / w;  // a quarter of a period: its surface is at rest
  ASSERT_FALSE(solver->advance(std::llround(time / scene.time.step)));
  EXPECT_NEAR((p.velocity[0].x + r * p.spin[0]) / 1e-4, 0.0, 5e-3);
  EXPECT_NEAR(p.velocity[0].x / 1e-4, 5.0 / 7.0, 5e-3);
}

TEST(Hertz, LongestStepResolvesTheStiffestContact) {
  Scene scene = hertzian(1.0);
  const double overlap = scene.limits.warnOverlap * scene.particles.diameter;
  const double modulus = 5e6 / (2.0 * (1.0 - 0.09));
  EXPECT_NEAR(normalStiffness(scene), 4.0 / 3.0 * modulus * std::sqrt(0.002 * overlap), 1e-9);
}

}  // namespace
}  // namespace bedmix
