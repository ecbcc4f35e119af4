// SPDX-License-Identifier: MIT
#include "engine/dem/packing.h"
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
  for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::rk4}) {
    Scene scene = smoothSpheres();
    scene.gravity = 9.81;
    scene.time.integrator = integrator;
    const auto solver = solverAt(scene, {{0.0, 1.0}});
    solver->particles().vx[0] = 0.3;
    solver->particles().fx[0] = 2.0 * solver->particles().mass;
    ASSERT_FALSE(solver->advance(10000));
    EXPECT_NEAR(solver->particles().x[0], 0.3 * 0.1 + 0.01, 1e-12);
    EXPECT_NEAR(solver->particles().y[0], 1.0 - 0.5 * 9.81 * 0.01, 1e-12);
    EXPECT_NEAR(solver->particles().vy[0], -0.981, 1e-12);
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
  for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::rk4}) {
    Scene scene = smoothSpheres();
    scene.time.integrator = integrator;
    const std::vector<Vec2> places{{0.01, 0.01}, {0.02, 0.01}, {0.03, 0.01}};
    const auto start = solverAt(scene, places);
    start->particles().vy[1] = nan;
    auto trouble = start->advance(1);
    ASSERT_TRUE(trouble);
    EXPECT_TRUE(trouble->nonFinite);
    EXPECT_EQ(trouble->particle, 1);
    EXPECT_STREQ(trouble->stage, "start");

    const auto dragged = solverAt(scene, places);
    ASSERT_FALSE(dragged->advance(10));
    dragged->particles().fx[2] = nan;
    trouble = dragged->advance(10);
    ASSERT_TRUE(trouble);
    EXPECT_TRUE(trouble->nonFinite);
    EXPECT_TRUE(std::isnan(trouble->value));
    EXPECT_EQ(trouble->particle, 2);
    EXPECT_STREQ(trouble->stage, "drag");

    const auto torn = solverAt(scene, places);
    torn->particles().fx[0] = 1e308;  // finite, but the speed soon is not
    trouble = torn->advance(10000);
    ASSERT_TRUE(trouble);
    EXPECT_TRUE(trouble->nonFinite);
    EXPECT_EQ(trouble->particle, 0);
    EXPECT_STREQ(trouble->stage, "integrate");
  }
}

TEST(Solver, StopsAboveTheOverlapLimitAndNamesTheParticle) {
  for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::rk4}) {
    Scene scene = smoothSpheres();
    scene.time.integrator = integrator;
    const auto solver = solverAt(scene, {{0.0, 0.1}, {0.01, 0.1}, {0.0136, 0.1}});
    scene.limits.maxOverlap = 0.1;
    ASSERT_FALSE(solver->advance(0));
    solver->particles().vx[1] = 1.5;
    const auto trouble = solver->advance(100);
    ASSERT_TRUE(trouble);
    EXPECT_FALSE(trouble->nonFinite);
    EXPECT_EQ(trouble->particle, 1);
    EXPECT_GT(trouble->value, 0.1);
    EXPECT_STREQ(trouble->stage, "contacts");
  }
}

TEST(Solver, RecordsTheDeepestOverlap) {
  Scene scene = smoothSpheres();
  scene.contacts.restitution = 1.0;
  const auto solver = solverAt(scene, {{0.01, 0.1}, {0.0, 0.002 + 1e-6}}, wideFloor());
  solver->particles().vy[1] = -0.2;
  ASSERT_FALSE(solver->advance(200));
  const double depth = 0.2 * std::sqrt(particleMass(scene) / scene.contacts.stiffness);
  EXPECT_NEAR(solver->largestOverlap(), depth / scene.particles.diameter, 1e-3 * depth / 0.004);
  EXPECT_EQ(solver->largestOverlapParticle(), 1);
}

TEST(DemDeterminism, SameSeedSameStateWhateverTheSteps) {
  for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::rk4}) {
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
  double& x = other->particles().x[17];
  x = std::nextafter(x, 1.0);
  EXPECT_NE(hashOf(*one), hashOf(*other));
  ASSERT_FALSE(one->advance(10));
  ASSERT_FALSE(other->advance(10));
  EXPECT_NE(hashOf(*one), hashOf(*other));
}

// One more sphere, far away and fast, has the neighbour list built anew all the time. The others must not
// notice: their contacts keep their springs, and sums do not depend on the list.
TEST(DemDeterminism, RebuildingTheListChangesNoBit) {
  for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::rk4}) {
    Scene scene = rainOfSpheres();
    scene.time.integrator = integrator;
    const auto alone = rain(scene);
    Particles more = *packBed(scene);
    for (auto* values : {&more.vx, &more.vy, &more.spin, &more.fx, &more.fy}) values->push_back(0.0);
    more.x.push_back(1.0);
    more.y.push_back(1.0);
    more.vx.back() = 20.0;
    const auto hurried = ParticleSolver::make(scene, std::move(more), bedWalls(scene));
    for (int piece = 0; piece < 2000; ++piece) {
      ASSERT_FALSE(alone->advance(10));
      ASSERT_FALSE(hurried->advance(10));
      for (std::size_t i = 0; i < alone->particles().size(); ++i) {
        ASSERT_EQ(alone->particles().x[i], hurried->particles().x[i]) << "piece " << piece;
        ASSERT_EQ(alone->particles().spin[i], hurried->particles().spin[i]) << "piece " << piece;
      }
    }
    EXPECT_GT(hurried->neighbourBuilds(), 5 * alone->neighbourBuilds());
    EXPECT_GT(alone->contactCount(), 30);
  }
}

// Tangential springs belong to the state: two beds alike but for their springs differ.
TEST(DemDeterminism, SpringsAreInTheHash) {
  Scene scene = smoothSpheres();
  scene.contacts.friction = FrictionSettings{};
  const auto slid = solverAt(scene, {{0.0, 0.00199}}, wideFloor());
  slid->particles().vx[0] = 0.1;
  ASSERT_FALSE(slid->advance(3));
  const auto fresh = ParticleSolver::make(scene, slid->particles(), wideFloor());
  EXPECT_NE(hashOf(*slid), hashOf(*fresh));
}

}  // namespace
}  // namespace bedmix
