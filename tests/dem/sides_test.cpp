// SPDX-License-Identifier: MIT
#include "engine/core/walls.h"
#include "engine/dem/packing.h"
#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace bedmix {
namespace {

constexpr double width = 0.048;  // m, of the beds

struct Law {
  std::string name;
  std::function<void(Scene&)> choose;
};

Scene between(const Law& law) {
  Scene scene = smoothSpheres();
  scene.bed.width = width;
  scene.bed.sides = BedSides::periodic;
  scene.time.step = 2e-6;
  law.choose(scene);
  return scene;
}

double aroundX(double x) { return x - width * std::floor(x / width); }

/// Far less than anything here moves, far more than rounding leaves.
constexpr double roundOff = 1e-11;  // m, m/s

class PeriodicSides : public testing::TestWithParam<Law> {};

// Minimum image: what happens at the seam is what happens in the middle of the bed.
TEST_P(PeriodicSides, PairMeetsAcrossTheSeamAsElsewhere) {
  const Scene scene = between(GetParam());
  const double d = scene.particles.diameter;
  const auto meet = [&](double x) {
    auto solver = solverAt(scene, {{aroundX(x - 0.52 * d), 0.02}, {aroundX(x + 0.49 * d), 0.0212}});
    Particles& p = solver->particles();
    p.velocity = {{0.3, 0.02}, {-0.2, -0.05}};
    if (!p.spin.empty()) p.spin = {20.0, 5.0};
    return solver;
  };
  const auto middle = meet(width / 2.0), seam = meet(0.0);
  bool touched = false;
  for (int k = 0; k < 120; ++k) {
    ASSERT_FALSE(middle->advance(100));
    ASSERT_FALSE(seam->advance(100));
    touched = touched || middle->contactCount() > 0;
    ASSERT_EQ(seam->contactCount(), middle->contactCount()) << k;
    EXPECT_NEAR(seam->elasticEnergy(), middle->elasticEnergy(), 1e-15) << k;
    const Particles a = inOrderOfIds(middle->particles()), b = inOrderOfIds(seam->particles());
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_GE(b.position[i].x, 0.0);
      EXPECT_LE(b.position[i].x, width);
      EXPECT_NEAR(std::remainder(b.position[i].x - a.position[i].x - width / 2.0, width), 0.0, roundOff);
      EXPECT_NEAR(b.position[i].y, a.position[i].y, roundOff);
      EXPECT_NEAR(b.velocity[i].x, a.velocity[i].x, 1e3 * roundOff);
      EXPECT_NEAR(b.velocity[i].y, a.velocity[i].y, 1e3 * roundOff);
      if (!a.spin.empty()) {
        EXPECT_NEAR(b.spin[i], a.spin[i], 1e-6);
      }
    }
  }
  EXPECT_TRUE(touched);
}

void withFriction(Scene& s) { s.contacts.friction.emplace(); }
INSTANTIATE_TEST_SUITE_P(Laws, PeriodicSides,
                         testing::Values(Law{"linear", [](Scene&) {}}, Law{"friction", withFriction},
                                         Law{"onset",
                                             [](Scene& s) {
                                               withFriction(s);
                                               s.time.integrator = Integrator::verletOnset;
                                             }},
                                         Law{"rk4",
                                             [](Scene& s) {
                                               withFriction(s);
                                               s.time.integrator = Integrator::rk4;
                                             }},
                                         Law{"hertz",
                                             [](Scene& s) {
                                               withFriction(s);
                                               s.contacts.stiffness.reset();
                                               s.contacts.hertz = HertzSettings{1e7, 0.25};
                                             }},
                                         Law{"rolling",
                                             [](Scene& s) {
                                               withFriction(s);
                                               s.contacts.rolling.emplace();
                                             }},
                                         Law{"wet",
                                             [](Scene& s) {
                                               withFriction(s);
                                               CohesionSettings cohesion;
                                               cohesion.liquidBridge =
                                                   LiquidBridgeSettings{.surfaceTension = 0.5,
                                                                        .volume = 1e-2,
                                                                        .contactAngleDeg = 20.0};
                                               s.effects.at<CohesionSettings>() = cohesion;
                                             }}),
                         [](const auto& tried) { return tried.param.name; });

/// A dense and lively gas of spheres, all of them moved to the right by `shift` (m).
std::unique_ptr<ParticleSolver> lively(const Scene& scene, double shift, ThreadTeam& team = oneThread()) {
  std::vector<Vec2> places, velocities;
  for (int i = 0; i < 200; ++i) {
    const double column = i % 10, row = i / 10;
    places.push_back({aroundX((0.5 + column) * 0.0048 + shift), 0.003 + 0.0043 * row});
    velocities.push_back({0.5 * std::sin(12.9898 * i + 0.3), 0.5 * std::sin(78.233 * i)});
  }
  auto solver = ParticleSolver::make(scene, makeParticles(scene, places), allWalls(scene), team);
  solver->particles().velocity = velocities;
  return solver;
}

Scene livelyScene() {
  Scene scene = between({"", withFriction});
  scene.gravity = 9.81;
  return scene;
}

Vec2 momentum(const Particles& p) {
  Vec2 sum;
  for (std::size_t i = 0; i < p.size(); ++i) sum += p.massOf(i) * p.velocity[i];
  return sum;
}

// Nothing in the bed tells where the seam is.
TEST(PeriodicBed, IsTheSameWhereverItsSeamIs) {
  const Scene scene = livelyScene();
  const auto here = lively(scene, 0.0), there = lively(scene, width / 3.0);
  for (int k = 0; k < 20; ++k) {
    ASSERT_FALSE(here->advance(100));
    ASSERT_FALSE(there->advance(100));
  }
  EXPECT_GT(here->contactCount(), 20);
  EXPECT_EQ(there->contactCount(), here->contactCount());
  EXPECT_NEAR(there->kineticEnergy() / here->kineticEnergy(), 1.0, 1e-9);
  EXPECT_NEAR(there->elasticEnergy() / here->elasticEnergy(), 1.0, 1e-7);
  const Particles a = inOrderOfIds(here->particles()), b = inOrderOfIds(there->particles());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(std::remainder(b.position[i].x - a.position[i].x - width / 3.0, width), 0.0, 1e-9) << i;
    EXPECT_NEAR(b.position[i].y, a.position[i].y, 1e-9) << i;
  }
}

// Without friction at the floor nothing can push the bed sideways; side walls can.
TEST(PeriodicBed, KeepsItsMomentumSideways) {
  for (const Integrator integrator : allIntegrators()) {
    Scene scene = livelyScene();
    scene.contacts.friction.reset();
    scene.time.integrator = integrator;
    const auto drift = [&] {
      const auto solver = lively(scene, 0.0);
      const double before = momentum(solver->particles()).x;
      EXPECT_FALSE(solver->advance(20000));
      return std::abs(momentum(solver->particles()).x - before);
    };
    const double scale = 200 * particleMass(scene) * 0.5;
    EXPECT_LT(drift(), 1e-12 * scale) << modelName(integrator);
    scene.bed.sides = BedSides::walls;
    EXPECT_GT(drift(), 1e-3 * scale) << modelName(integrator);
  }
}

// Around and around: lists are made anew all the time, and a free particle does not notice.
TEST(PeriodicBed, FreeFlightGoesAround) {
  Scene scene = between({"", [](Scene&) {}});
  auto solver = solverAt(scene, {{0.01, 0.02}, {0.03, 0.05}, {0.04, 0.08}});
  for (Vec2& v : solver->particles().velocity) v = {1.7, 0.0};
  ASSERT_FALSE(solver->advance(100000));
  EXPECT_GT(solver->neighbourBuilds(), 10);
  const Particles p = inOrderOfIds(solver->particles());
  EXPECT_NEAR(p.position[0].x, aroundX(0.01 + 1.7 * 0.2), 1e-10);
  EXPECT_NEAR(p.position[2].x, aroundX(0.04 + 1.7 * 0.2), 1e-10);
}

TEST(PeriodicBed, ListsHoldAllPairsAcrossTheSeam) {
  const Scene scene = livelyScene();
  const auto solver = lively(scene, 0.0);
  std::int64_t across = 0;
  for (int k = 0; k < 100; ++k) {
    ASSERT_FALSE(solver->advance(200));
    const Particles& p = solver->particles();
    std::int64_t touching = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = i + 1; j < p.size(); ++j) {
        const Vec2 apart = p.position[j] - p.position[i];
        const double nearest = std::hypot(std::remainder(apart.x, width), apart.y);
        touching += nearest < scene.particles.diameter;
        across += nearest < scene.particles.diameter && norm(apart) > scene.particles.diameter;
      }
    for (const Vec2 at : p.position) touching += at.y < scene.particles.diameter / 2.0;
    ASSERT_EQ(solver->contactCount(), touching) << k;
  }
  EXPECT_GT(across, 20);
}

TEST(PeriodicBed, DemDeterminismOverThreadsAndResume) {
  const Scene scene = livelyScene();
  const auto hashOf = [](const ParticleSolver& solver) {
    StateHash hash;
    solver.hashInto(hash);
    return hash.value();
  };
  ThreadTeam two(2);
  const auto alone = lively(scene, 0.0), together = lively(scene, 0.0, two);
  for (int k = 0; k < 10; ++k) {
    ASSERT_FALSE(alone->advance(500));
    ASSERT_FALSE(together->advance(500));
  }
  EXPECT_EQ(hashOf(*together), hashOf(*alone));
  StateWriter saved(0);
  alone->save(saved);
  const std::vector<std::byte> bytes = saved.take();
  const auto resumed = lively(scene, 0.0);
  StateReader in(bytes);
  ASSERT_TRUE(resumed->load(in));
  ASSERT_FALSE(alone->advance(3000));
  ASSERT_FALSE(resumed->advance(3000));
  EXPECT_EQ(hashOf(*resumed), hashOf(*alone));
}

// A packed bed spreads over the whole width: who is beside the seam rests on who is on the other side.
TEST(PeriodicBed, SettlesWithoutWalls) {
  Scene scene = livelyScene();
  scene.particles.count = 300;
  scene.time.step = 1e-5;
  const auto start = packBed(scene);
  ASSERT_TRUE(start);
  double lowest = width, highest = 0.0, top = 0.0;
  for (const Vec2 at : start->position) {
    lowest = std::min(lowest, at.x);
    highest = std::max(highest, at.x);
    top = std::max(top, at.y);
  }
  EXPECT_LT(lowest, 0.5 * 0.004);  // where a wall would let none be
  EXPECT_GT(highest, width - 0.5 * 0.004);
  EXPECT_NEAR(top, 300.0 / (width / 0.004) * 0.004, 0.25 * top);
}

}  // namespace
}  // namespace bedmix
