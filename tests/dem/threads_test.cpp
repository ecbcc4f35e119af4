// SPDX-License-Identifier: MIT
#include "engine/core/rng.h"
#include "engine/core/simd.h"
#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace bedmix {
namespace {

constexpr int checkpoints = 4;
constexpr std::int64_t stepsBetween = 500;
using Hashes = std::array<std::uint64_t, checkpoints>;

/// Five thousand rough spheres in a box, close packed with gaps and thrown at each other: several blocks,
/// contacts across them, at walls, and lists made anew.
Hashes advanceCrowd(Integrator integrator, ThreadTeam& team = oneThread()) {
  Scene scene = smoothSpheres();
  scene.time.integrator = integrator;
  scene.gravity = 9.81;
  scene.contacts.friction = FrictionSettings{};
  scene.limits.maxOverlap = 0.4;
  const double d = scene.particles.diameter, spacing = 1.02 * d;
  std::vector<Vec2> positions;
  for (int i = 0; i < 5000; ++i) {
    const int row = i / 100, column = i % 100;
    positions.push_back({(0.6 + column + 0.5 * (row % 2)) * spacing, (0.6 + 0.87 * row) * spacing});
  }
  const auto solver =
      ParticleSolver::make(scene, makeParticles(scene, positions), closedBox(101.7 * spacing, 0.3), team);
  Rng rng(4);
  for (Vec2& v : solver->particles().velocity) v = {rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)};
  Hashes hashes{};
  for (std::uint64_t& hash : hashes) {
    EXPECT_FALSE(solver->advance(stepsBetween));
    StateHash state;
    solver->hashInto(state);
    hash = state.value();
  }
  EXPECT_GT(solver->neighbourBuilds(), 3);
  EXPECT_GT(solver->contactCount(), 500);
  return hashes;
}

class DemDeterminism : public testing::TestWithParam<Integrator> {};

TEST_P(DemDeterminism, ThreadsChangeNoBit) {
  const Hashes one = advanceCrowd(GetParam());
  for (const int threads : {2, 3, 4, 8}) {
    ThreadTeam team(threads);
    EXPECT_EQ(advanceCrowd(GetParam(), team), one) << threads << " threads";
  }
}

TEST_P(DemDeterminism, SimdLevelsChangeNoBit) {
  const SimdLevel before = simdLevel();
  ASSERT_TRUE(useSimdLevel(SimdLevel::baseline));
  const Hashes baseline = advanceCrowd(GetParam());
  for (const SimdLevel level : {SimdLevel::avx2, SimdLevel::avx512})
    if (useSimdLevel(level)) {
      EXPECT_EQ(advanceCrowd(GetParam()), baseline) << simdLevelNames()[static_cast<std::size_t>(level)];
    }
  ASSERT_TRUE(useSimdLevel(before));
}

// RK4 runs on one thread, in the same loops.
INSTANTIATE_TEST_SUITE_P(Integrators, DemDeterminism,
                         testing::Values(Integrator::velocityVerlet, Integrator::symplecticEuler,
                                         Integrator::verletOnset),
                         nameOfIntegrator);

}  // namespace
}  // namespace bedmix
