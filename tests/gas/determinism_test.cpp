// SPDX-License-Identifier: MIT
#include "engine/core/simd.h"
#include "engine/dem/packing.h"
#include "engine/simulation.h"
#include "engine/worker.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace bedmix {
namespace {

/// Sixty particles in a gas that lifts them: quick, with every stage in it.
Scene smallScene() {
  Scene scene = test::lowScene(60, 2.6);
  scene.time.duration = 0.05;
  return scene;
}

TEST(Determinism, TwoSimulationsAgreeStepByStep) {
  Simulation a = test::simulate(smallScene(), 1), b = test::simulate(smallScene(), 2);
  ASSERT_EQ(a.stateHash(), b.stateHash());
  for (int k = 0; k < 200; ++k) {
    ASSERT_EQ(a.advance(10), std::nullopt);
    ASSERT_EQ(b.advance(10), std::nullopt);
    ASSERT_EQ(a.stateHash(), b.stateHash()) << "step " << a.step();
  }
}

/// A bed so large that threads are really used, in a gas grid that is solved by many iterations; heavy, so
/// that it falls into contact at once.
Scene largeScene() {
  Scene scene = test::paperScene(2.6);
  scene.bed.width = 0.48;
  scene.bed.height = 1.32;
  scene.gravity = 200.0;
  scene.limits.maxOverlap = 0.4;
  scene.particles.count = 9000;
  scene.gas->grid.columns = {{40, 0.012}};
  scene.gas->grid.rows = {{110, 0.012}};
  scene.start.arrangement = Arrangement::drop;
  return scene;
}

/// State hashes at 500, 1,000, 1,500 and 2,000 steps.
std::vector<std::uint64_t> checkpoints(const Scene& scene, int threads) {
  Simulation simulation = test::simulate(scene, threads);
  std::vector<std::uint64_t> hashes;
  for (int checkpoint = 0; checkpoint < 4; ++checkpoint) {
    EXPECT_EQ(simulation.advance(500), std::nullopt);
    hashes.push_back(simulation.stateHash());
  }
  EXPECT_GT(simulation.contacts(), 1000);
  return hashes;
}

TEST(Determinism, ThreadsChangeNoBitOfTwoThousandSteps) {
  const std::vector<std::uint64_t> one = checkpoints(largeScene(), 1);
  for (const int threads : {2, 3, 4, 8})
    EXPECT_EQ(checkpoints(largeScene(), threads), one) << threads << " threads";
}

TEST(Determinism, SimdLevelsChangeNoBitOfTwoThousandSteps) {
  const SimdLevel before = simdLevel();
  ASSERT_TRUE(useSimdLevel(SimdLevel::baseline));
  const std::vector<std::uint64_t> baseline = checkpoints(largeScene(), 1);
  for (const SimdLevel level : {SimdLevel::avx2, SimdLevel::avx512})
    if (useSimdLevel(level)) {
      EXPECT_EQ(checkpoints(largeScene(), 2), baseline) << simdLevelNames()[static_cast<std::size_t>(level)];
    }
  ASSERT_TRUE(useSimdLevel(before));
}

TEST(Determinism, ChosenStepsAreTheSameForAnyThreadsAndVectors) {
  Scene scene = largeScene();
  scene.time.step = scene.gas->step = StepLength::automatic();
  const auto endOf = [&](int threads) {
    Simulation simulation = test::simulate(scene, threads);
    EXPECT_EQ(simulation.advance(stepsPerFrame(scene)), std::nullopt);
    EXPECT_GT(simulation.contacts(), 300);
    return std::pair(simulation.stateHash(), simulation.particleSteps());
  };
  const auto one = endOf(1);
  EXPECT_EQ(endOf(3), one);
  const SimdLevel before = simdLevel();
  ASSERT_TRUE(useSimdLevel(SimdLevel::baseline));
  EXPECT_EQ(endOf(1), one);
  ASSERT_TRUE(useSimdLevel(before));
}

TEST(Determinism, AStartOfOnesOwnIsAStartLikeAnyOther) {
  Simulation packed = test::simulate(smallScene());
  Simulation given = Simulation::make(smallScene(), *packBed(smallScene()), 2);
  ASSERT_EQ(packed.stateHash(), given.stateHash());
  ASSERT_EQ(packed.advance(100), std::nullopt);
  ASSERT_EQ(given.advance(100), std::nullopt);
  EXPECT_EQ(packed.stateHash(), given.stateHash());
  EXPECT_GT(packed.contacts(), 60);  // the bed still lies on the floor
  EXPECT_EQ(packed.contacts(), given.contacts());
}

TEST(Determinism, BedsGetAsManyThreadsAsPayOff) {
  EXPECT_EQ(threadsFor(60, 4), 1);
  EXPECT_EQ(threadsFor(9999, 4), 1);
  EXPECT_EQ(threadsFor(10000, 4), 2);
  EXPECT_EQ(threadsFor(100000, 4), 4);
  EXPECT_EQ(threadsFor(100000, 64), 24);
  EXPECT_EQ(threadsFor(100000, 0), 1);
}

TEST(Determinism, HowStepsAreAskedForDoesNotMatter) {
  Simulation a = test::simulate(smallScene()), b = test::simulate(smallScene());
  ASSERT_EQ(a.advance(2003), std::nullopt);
  for (std::int64_t n : {1, 9, 10, 13, 970, 1000}) ASSERT_EQ(b.advance(n), std::nullopt);
  EXPECT_EQ(a.stateHash(), b.stateHash());
  EXPECT_EQ(a.gasSteps(), 200);
}

TEST(Determinism, SeedMovesTheStateAndNothingElseDoes) {
  Scene other = smallScene();
  other.seed = 2;
  EXPECT_NE(test::simulate(smallScene()).stateHash(), test::simulate(other).stateHash());
  other.seed = 1;
  other.sampling.interval = 0.005;
  EXPECT_EQ(test::simulate(smallScene()).stateHash(), test::simulate(other).stateHash());
}

TEST(Worker, HandsOutEveryFrameInOrderAndEndsLikeTheSimulation) {
  const Scene scene = smallScene();
  Worker worker(scene);
  int frames = 0;
  while (FramePtr frame = worker.next()) {
    EXPECT_EQ(frame->step, 1000 * frames);
    EXPECT_EQ(frame->time, frames * 0.01);
    ++frames;
  }
  EXPECT_EQ(frames, 6);
  Simulation simulation = test::simulate(scene);
  ASSERT_EQ(simulation.advance(totalSteps(scene)), std::nullopt);
  EXPECT_EQ(worker.end().stateHash, simulation.stateHash());
  EXPECT_EQ(worker.end().reason, EndReason::finished);
}

TEST(Worker, FramesFallOnTheirTimesWhereStepsAreChosen) {
  Scene scene = smallScene();
  scene.time.step = scene.gas->step = StepLength::automatic();
  scene.time.integrator = Integrator::verletOnset;
  Worker worker(scene);
  int frames = 0;
  while (FramePtr frame = worker.next()) {
    EXPECT_EQ(frame->step, 5040 * frames);
    EXPECT_EQ(frame->time, frames * 0.01);
    ++frames;
  }
  EXPECT_EQ(frames, 6);
  const RunEnd& end = worker.end();
  EXPECT_EQ(end.reason, EndReason::finished) << end.message;
  EXPECT_EQ(end.simulatedSeconds, 0.05);
  EXPECT_LT(end.steps, 5000);  // those of 1e-5 s
  EXPECT_GE(end.steps, 0.05 / longestStep(scene));
  EXPECT_LE(end.gasSteps, end.steps);
}

TEST(Worker, StopsOnRequestWithTheFramesInHand) {
  Scene scene = smallScene();
  scene.time.duration = 1000.0;
  Worker worker(scene);
  ASSERT_NE(worker.next(), nullptr);
  worker.requestStop();
  while (worker.next()) {
  }
  EXPECT_EQ(worker.end().reason, EndReason::stopped);
}

TEST(Worker, ReportsAnInvalidSolution) {
  Scene scene = smallScene();
  scene.start.arrangement = Arrangement::drop;
  scene.limits.maxOverlap = 1e-9;
  scene.time.duration = 1.0;
  Worker worker(scene);
  while (worker.next()) {
  }
  EXPECT_EQ(worker.end().reason, EndReason::invalid);
  EXPECT_NE(worker.end().message.find("limits.max_overlap"), std::string::npos);
}

}  // namespace
}  // namespace bedmix
