// SPDX-License-Identifier: MIT
#include "engine/dem/packing.h"
#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bedmix {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Scene rainOfSpheres() {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  scene.contacts.friction = FrictionSettings{};
  scene.bed.width = 0.04;
  scene.particles.count = 60;
  scene.start.arrangement = Arrangement::drop;
  return scene;
}

std::uint64_t hashOf(const ParticleSolver& solver) {
  StateHash hash;
  solver.hashInto(hash);
  return hash.value();
}

std::unique_ptr<ParticleSolver> rain(const Scene& scene) {
  return ParticleSolver::make(scene, *packBed(scene), bedWalls(scene));
}

TEST(Solver, FreeFallIsExact) {
  for (const Integrator integrator : allIntegrators()) {
    Scene scene = smoothSpheres();
    scene.gravity = 9.81;
    scene.time.integrator = integrator;
    const auto solver = solverAt(scene, {{0.0, 1.0}});
    solver->particles().velocity[0].x = 0.3;
    solver->particles().addExternalForces();
    solver->particles().external[0].x = 2.0 * solver->particles().mass;
    ASSERT_FALSE(solver->advance(10000));
    // Symplectic Euler moves on with the velocity at the end of a step.
    const double ahead = integrator == Integrator::symplecticEuler ? 1e-5 : 0.0;
    EXPECT_NEAR(solver->particles().position[0].x, 0.3 * 0.1 + 0.1 * (0.1 + ahead), 1e-12);
    EXPECT_NEAR(solver->particles().position[0].y, 1.0 - 0.5 * 9.81 * 0.1 * (0.1 + ahead), 1e-12);
    EXPECT_NEAR(solver->particles().velocity[0].y, -0.981, 1e-12);
  }
}

TEST(Solver, EmptyBedAdvances) {
  const auto solver = solverAt(smoothSpheres(), {}, wideFloor());
  EXPECT_FALSE(solver->advance(100));
  EXPECT_EQ(solver->contactCount(), 0);
  EXPECT_EQ(solver->largestOverlapParticle(), -1);
}

TEST(Solver, WithoutFrictionNothingSpins) {
  const auto solver = solverAt(smoothSpheres(), {{0.0, 0.0019}, {0.0039, 0.0019}}, wideFloor());
  EXPECT_FALSE(solver->advance(100));
  EXPECT_TRUE(solver->particles().spin.empty());
}

TEST(Solver, NamesTheParticleThatIsNotFinite) {
  for (const Integrator integrator : allIntegrators()) {
    Scene scene = smoothSpheres();
    scene.time.integrator = integrator;
    const std::vector<Vec2> places{{0.01, 0.01}, {0.02, 0.01}, {0.03, 0.01}};
    const auto start = solverAt(scene, places);
    start->particles().velocity[1].y = nan;
    auto trouble = start->advance(1);
    ASSERT_TRUE(trouble);
    EXPECT_EQ(trouble->kind, DemTrouble::Kind::nonFinite);
    EXPECT_EQ(trouble->particle, 1);
    EXPECT_STREQ(trouble->stage, "start");

    const auto dragged = solverAt(scene, places);
    dragged->particles().addExternalForces();
    ASSERT_FALSE(dragged->advance(10));
    dragged->particles().external[2].x = nan;
    trouble = dragged->advance(10);
    ASSERT_TRUE(trouble);
    EXPECT_EQ(trouble->kind, DemTrouble::Kind::nonFinite);
    EXPECT_TRUE(std::isnan(trouble->value));
    EXPECT_EQ(trouble->particle, 2);
    EXPECT_STREQ(trouble->stage, "drag");

    const auto torn = solverAt(scene, places);
    torn->particles().addExternalForces();
    torn->particles().external[0].x = 1e308;  // finite, but the speed soon is not
    trouble = torn->advance(10000);
    ASSERT_TRUE(trouble);
    EXPECT_EQ(trouble->kind, DemTrouble::Kind::nonFinite);
    EXPECT_EQ(trouble->particle, 0);
    EXPECT_STREQ(trouble->stage, "integrate");
  }
}

// A wall that is passed within one step is not seen: nothing overlaps it before or after.
TEST(Solver, StopsBeforeAParticlePassesAWallUnseen) {
  for (const Integrator integrator : allIntegrators()) {
    Scene scene = smoothSpheres();
    scene.time.integrator = integrator;
    const double d = scene.particles.diameter, tooFast = 1.01 * furthestInAStep * d / scene.time.step;
    const auto solver = solverAt(scene, {{0.0, 30.0 * d}, {3.0 * d, 20.6 * d}}, wideFloor());
    solver->particles().velocity[1].y = -tooFast;
    const auto trouble = solver->advance(10);
    ASSERT_TRUE(trouble);
    EXPECT_EQ(trouble->kind, DemTrouble::Kind::speed);
    EXPECT_EQ(trouble->particle, 1);
    EXPECT_NEAR(trouble->value, 1.01 * furthestInAStep, 1e-9);

    // At the limit it is seen by its overlap, wherever its steps fall.
    for (double phase = 0.0; phase < 1.0; phase += 0.1) {
      const auto seen = solverAt(scene, {{0.0, (4.0 + phase * furthestInAStep) * d}}, wideFloor());
      seen->particles().velocity[0].y = -0.999 * furthestInAStep * d / scene.time.step;
      const auto overlap = seen->advance(20);
      ASSERT_TRUE(overlap) << phase;
      EXPECT_EQ(overlap->kind, DemTrouble::Kind::overlap) << phase;
    }
  }
}

TEST(Solver, StopsAboveTheOverlapLimitAndNamesTheParticle) {
  for (const Integrator integrator : allIntegrators()) {
    Scene scene = smoothSpheres();
    scene.time.integrator = integrator;
    const auto solver = solverAt(scene, {{0.0, 0.1}, {0.01, 0.1}, {0.0136, 0.1}});
    scene.limits.maxOverlap = 0.1;
    ASSERT_FALSE(solver->advance(0));
    solver->particles().velocity[1].x = 1.5;
    const auto trouble = solver->advance(100);
    ASSERT_TRUE(trouble);
    EXPECT_EQ(trouble->kind, DemTrouble::Kind::overlap);
    EXPECT_EQ(trouble->particle, 1);
    EXPECT_GT(trouble->value, 0.1);
    EXPECT_STREQ(trouble->stage, "contacts");
  }
}

TEST(Solver, RecordsTheDeepestOverlap) {
  Scene scene = smoothSpheres();
  scene.contacts.restitution = 1.0;
  const auto solver = solverAt(scene, {{0.01, 0.1}, {0.0, 0.002 + 1e-6}}, wideFloor());
  solver->particles().velocity[1].y = -0.2;
  ASSERT_FALSE(solver->advance(200));
  const double depth = 0.2 * std::sqrt(particleMass(scene) / normalStiffness(scene));
  EXPECT_NEAR(solver->largestOverlap(), depth / scene.particles.diameter, 1e-3 * depth / 0.004);
  EXPECT_EQ(solver->largestOverlapParticle(), 1);
}

TEST(DemDeterminism, SameSeedSameStateWhateverTheSteps) {
  for (const Integrator integrator : allIntegrators()) {
    Scene scene = rainOfSpheres();
    scene.time.integrator = integrator;
    const auto one = rain(scene), other = rain(scene);
    for (int piece = 0; piece < 1000; ++piece) {
      ASSERT_FALSE(one->advance(20));
      for (int step = 0; step < 20; ++step) ASSERT_FALSE(other->advance(1));
      ASSERT_EQ(hashOf(*one), hashOf(*other)) << "piece " << piece;
    }
    EXPECT_GT(one->contactCount(), 30);
    scene.seed = 2;
    const auto third = rain(scene);
    ASSERT_FALSE(third->advance(20000));
    EXPECT_NE(hashOf(*one), hashOf(*third));
  }
}

TEST(DemDeterminism, OneBitOfOneCoordinateShows) {
  const Scene scene = rainOfSpheres();
  const auto one = rain(scene), other = rain(scene);
  double& x = other->particles().position[17].x;
  x = std::nextafter(x, 1.0);
  EXPECT_NE(hashOf(*one), hashOf(*other));
  ASSERT_FALSE(one->advance(10));
  ASSERT_FALSE(other->advance(10));
  EXPECT_NE(hashOf(*one), hashOf(*other));
}

// One more sphere, far away and fast, has the contact list built anew and the particles sorted anew all the
// time. A heap at rest stands on its springs: losing one would let it slip by some of what they are
// stretched.
TEST(DemDeterminism, RebuildingTheListLosesNoSpring) {
  for (const Integrator integrator : allIntegrators()) {
    Scene scene = rainOfSpheres();
    scene.time.integrator = integrator;
    const auto alone = rain(scene);
    ASSERT_FALSE(alone->advance(40000));
    Particles more = inOrderOfIds(alone->particles());
    const Particles less = more;
    more.id.push_back(60);
    more.position.push_back({1.0, 1.0});
    more.velocity.push_back({20.0, 0.0});
    more.spin.push_back(0.0);
    const auto calm = ParticleSolver::make(scene, less, bedWalls(scene));
    const auto hurried = ParticleSolver::make(scene, std::move(more), bedWalls(scene));
    ASSERT_FALSE(calm->advance(5000));
    ASSERT_FALSE(hurried->advance(5000));
    const Particles a = inOrderOfIds(calm->particles()), b = inOrderOfIds(hurried->particles());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(a.position[i].x, b.position[i].x, 1e-11 * scene.particles.diameter) << i;
      EXPECT_NEAR(a.position[i].y, b.position[i].y, 1e-11 * scene.particles.diameter) << i;
      EXPECT_NEAR(a.spin[i], b.spin[i], 1e-9) << i;
    }
    EXPECT_GT(hurried->neighbourBuilds(), 100);
    EXPECT_LE(calm->neighbourBuilds(), 2);
    EXPECT_GT(calm->contactCount(), 60);
  }
}

// Tangential springs belong to the state: two beds alike but for their springs differ.
TEST(DemDeterminism, SpringsAreInTheHash) {
  Scene scene = smoothSpheres();
  scene.contacts.friction = FrictionSettings{};
  const auto slid = solverAt(scene, {{0.0, 0.00199}}, wideFloor());
  slid->particles().velocity[0].x = 0.1;
  ASSERT_FALSE(slid->advance(3));
  const auto fresh = ParticleSolver::make(scene, slid->particles(), wideFloor());
  EXPECT_NE(hashOf(*slid), hashOf(*fresh));
}

}  // namespace
}  // namespace bedmix
