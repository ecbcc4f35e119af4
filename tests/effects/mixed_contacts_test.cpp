// SPDX-License-Identifier: MIT
#include "engine/core/particle_list.h"
#include "engine/core/rng.h"
#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bedmix {
namespace {

/// A hundred rough spheres in a box, close to each other and thrown about.
Scene crowd() {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  scene.particles.count = 100;
  scene.contacts.friction = FrictionSettings{};
  scene.limits.maxOverlap = 0.4;
  return scene;
}

std::unique_ptr<ParticleSolver> throwAbout(const Scene& scene, ThreadTeam& team = oneThread()) {
  const double d = particleRange(scene).largest;
  std::vector<Vec2> positions;
  for (std::int64_t i = 0; i < scene.particles.count; ++i) {
    const double row = std::floor(static_cast<double>(i) / 50.0), column = static_cast<double>(i % 50);
    positions.push_back({(0.6 + column) * 1.02 * d, (0.6 + row) * 1.02 * d});
  }
  const double rows = std::ceil(static_cast<double>(scene.particles.count) / 50.0);
  auto solver = ParticleSolver::make(scene, makeParticles(scene, positions),
                                     closedBox(51.2 * 1.02 * d, 3.0 * rows * d), team);
  Rng rng(4);
  for (Vec2& v : solver->particles().velocity) v = {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
  return solver;
}

class MixedContacts : public testing::TestWithParam<Integrator> {};

/// The law that looks up what each contact has agrees with the one for contacts that are all alike.
TEST_P(MixedContacts, OfEqualParticlesAreThoseOfAlikeOnes) {
  Scene plain = crowd();
  plain.time.integrator = GetParam();
  Scene mixed = plain;
  mixed.particles.species.push_back({"same", 40, std::nullopt, std::nullopt, std::nullopt});
  const auto one = throwAbout(plain), other = throwAbout(mixed);
  ASSERT_FALSE(one->advance(2000));
  ASSERT_FALSE(other->advance(2000));
  const Particles a = inOrderOfIds(one->particles()), b = inOrderOfIds(other->particles());
  double apart = 0.0, turned = 0.0, moved = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    apart = std::max(apart, norm(a.position[i] - b.position[i]));
    turned = std::max(turned, std::abs(a.spin[i] - b.spin[i]));
    moved = std::max(moved, std::abs(a.spin[i]));
  }
  EXPECT_GT(moved, 1.0);
  EXPECT_LT(apart, 1e-10);
  EXPECT_LT(turned, 1e-5);
}

/// Momentum is kept, and the relative velocity turns round with the restitution of the pair.
TEST_P(MixedContacts, UnequalSpheresRebound) {
  Scene scene = smoothSpheres();
  scene.time.integrator = GetParam();
  scene.time.step = 1e-6;
  scene.particles.count = 2;
  scene.particles.species.push_back({"small", 1, 0.002, 7000.0, std::nullopt});
  scene.contacts.pairs.push_back({"small", "first", 0.6, std::nullopt});
  scene.contacts.pairs.push_back({"small", "wall", 0.3, std::nullopt});
  const std::vector<std::uint8_t> kinds = particleList(scene).kinds;
  const std::size_t small = kinds[0] == 1 ? 0 : 1, large = 1 - small;
  std::vector<Vec2> at(2);
  at[small] = {0.003 + 3.3e-6, 0.5};
  at[large] = {0.0, 0.5};
  auto solver = solverAt(scene, at);
  Particles& p = solver->particles();
  p.velocity[small] = {-0.3, 0.0};
  p.velocity[large] = {0.1, 0.0};
  const double before = p.masses[small] * -0.3 + p.masses[large] * 0.1;
  ASSERT_FALSE(solver->advance(5000));
  const Particles after = inOrderOfIds(solver->particles());
  const double pair = after.velocity[small].x - after.velocity[large].x;
  EXPECT_NEAR(pair, 0.6 * 0.4, 1e-3);
  EXPECT_NEAR(after.masses[small] * after.velocity[small].x + after.masses[large] * after.velocity[large].x,
              before, 1e-14);

  at[small] = {0.0, 0.001 + 3.3e-6};
  at[large] = {0.5, 0.5};
  solver = solverAt(scene, at, wideFloor());
  solver->particles().velocity[small] = {0.0, -0.2};
  ASSERT_FALSE(solver->advance(5000));
  EXPECT_NEAR(inOrderOfIds(solver->particles()).velocity[small].y, 0.3 * 0.2, 2e-3 * 0.2);
}

/// A large one at rest that a small one slides by: the torque on each is the force times its own radius, so
/// that the spins are as radius over inertia.
TEST_P(MixedContacts, TorqueIsByEachOnesRadius) {
  Scene scene = smoothSpheres();
  scene.time.integrator = GetParam();
  scene.time.step = 1e-6;
  scene.contacts.friction = FrictionSettings{};
  scene.particles.count = 2;
  scene.particles.species.push_back({"small", 1, 0.002, std::nullopt, std::nullopt});
  const std::vector<std::uint8_t> kinds = particleList(scene).kinds;
  const std::size_t small = kinds[0] == 1 ? 0 : 1, large = 1 - small;
  std::vector<Vec2> at(2);
  at[small] = {0.003 + 1e-6, 0.0};
  const auto solver = solverAt(scene, at);
  solver->particles().velocity[small] = {-0.2, 0.3};
  ASSERT_FALSE(solver->advance(5000));
  const Particles p = inOrderOfIds(solver->particles());
  EXPECT_NE(p.spin[large], 0.0);
  EXPECT_NEAR(p.spin[small] * p.inertiaOf(small) / 0.001, p.spin[large] * p.inertiaOf(large) / 0.002,
              1e-9 * std::abs(p.spin[large] * p.inertiaOf(large) / 0.002));
}

INSTANTIATE_TEST_SUITE_P(All, MixedContacts,
                         testing::Values(Integrator::velocityVerlet, Integrator::rk4,
                                         Integrator::verletOnset),
                         nameOfIntegrator);

Scene sizes() {
  Scene scene = crowd();
  scene.particles.count = 3000;
  scene.particles.size = SizeSettings{SizeDistribution::normal, 0.15, 2.5};
  scene.particles.species.push_back({"small", 1500, 0.0025, 3000.0, std::nullopt});
  scene.contacts.rolling = RollingSettings{};
  scene.effects.at<CohesionSettings>().emplace().liquidBridge = LiquidBridgeSettings{.volume = 1e-4};
  scene.limits.maxOverlap = 0.5;
  return scene;
}

TEST(MixedContactsBed, KeepsEnergyAndMomentumOfElasticOnes) {
  Scene scene = sizes();
  scene.gravity = 0.0;
  scene.contacts.restitution = 1.0;
  scene.contacts.friction.reset();
  scene.contacts.rolling.reset();
  scene.effects.at<CohesionSettings>().reset();
  scene.particles.count = 500;
  scene.particles.species[0].count = 250;
  scene.time.step = 2e-6;
  const auto solver = throwAbout(scene);
  const double before = solver->kineticEnergy();
  ASSERT_FALSE(solver->advance(10000));
  EXPECT_GT(solver->contactCount(), 0);
  EXPECT_NEAR((solver->kineticEnergy() + solver->elasticEnergy()) / before, 1.0, 1e-3);
}

TEST(MixedContactsBed, IsTheSameWithAnyNumberOfThreadsAndGoesOnAfterASave) {
  const Scene scene = sizes();
  const auto hashOf = [](const ParticleSolver& solver) {
    StateHash hash;
    solver.hashInto(hash);
    return hash.value();
  };
  ThreadTeam team(3);
  const auto one = throwAbout(scene), many = throwAbout(scene, team);
  ASSERT_FALSE(one->advance(600));
  ASSERT_FALSE(many->advance(300));
  StateWriter out(0);
  many->save(out);
  const std::vector<std::byte> bytes = out.take();
  const auto resumed = throwAbout(scene);
  StateReader in(bytes);
  ASSERT_TRUE(resumed->load(in));
  ASSERT_FALSE(many->advance(300));
  ASSERT_FALSE(resumed->advance(300));
  EXPECT_EQ(hashOf(*many), hashOf(*one));
  EXPECT_EQ(hashOf(*resumed), hashOf(*one));
}

}  // namespace
}  // namespace bedmix
