// SPDX-License-Identifier: MIT
#include "engine/checkpoint.h"
#include "engine/core/refinement.h"
#include "engine/worker.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

std::vector<std::byte> checkpointAfter(const Scene& scene, std::int64_t steps) {
  Simulation simulation = test::simulate(scene);
  EXPECT_EQ(simulation.advance(steps), std::nullopt);
  return writeCheckpoint(simulation, scene, 2.0);
}

Simulation goOn(const std::vector<std::byte>& bytes, const Scene& scene, int threads = 1) {
  Result<Resumed> resumed = readCheckpoint(bytes, scene, threads);
  EXPECT_TRUE(resumed) << resumed.problems.front().message;
  return std::move(resumed->simulation);
}

// Gas steps are in the middle at 505.
TEST(RetryResume, GoesOnFromTheSameStateAtTheSameTime) {
  const Scene scene = test::lowScene(60, 3.0);
  for (const std::int64_t steps : {0, 500, 505}) {
    const std::vector<std::byte> bytes = checkpointAfter(scene, steps);
    const Simulation was = goOn(bytes, scene);
    for (const Refinement further : {Refinement{1, 0}, {1, 1}, {3, 2}}) {
      const Scene fine = refined(scene, further);
      Simulation is = goOn(bytes, fine);
      EXPECT_EQ(is.time(), was.time());
      EXPECT_EQ(is.step(), was.step() << further.particles);
      EXPECT_EQ(is.gasSteps(), was.gasSteps());
      EXPECT_EQ(is.frame()->position, was.frame()->position);
      EXPECT_EQ(is.frame()->velocity, was.frame()->velocity);
      EXPECT_EQ(is.frame()->gas.pressure, was.frame()->gas.pressure);

      // The gas step that has begun is ended as it is.
      ASSERT_EQ(is.advance((1000 << further.particles) - is.step() % (10 << further.particles)),
                std::nullopt);
      EXPECT_EQ(is.gasSteps(), was.gasSteps() + 1 + (99 << further.gas)) << steps;
    }
  }
}

TEST(RetryResume, HalfTheStepComesToTheSameBed) {
  const Scene scene = test::lowScene(60, 0.5);  // below minimum fluidization: it rests
  const std::vector<std::byte> bytes = checkpointAfter(scene, 500);
  Simulation coarse = goOn(bytes, scene), fine = goOn(bytes, refined(scene, {1, 1}));
  ASSERT_EQ(coarse.advance(5000), std::nullopt);
  ASSERT_EQ(fine.advance(10000), std::nullopt);
  EXPECT_EQ(fine.time(), coarse.time());
  for (std::size_t i = 0; i < 60; ++i)
    EXPECT_NEAR(fine.frame()->position[i].y, coarse.frame()->position[i].y, 1e-6);  // of 0.004 m
}

TEST(RetryResume, IsTheSameForAnyThreadsAndThroughAnotherCheckpoint) {
  const Scene scene = test::lowScene(60, 3.0), fine = refined(scene, {2, 1});
  const std::vector<std::byte> bytes = checkpointAfter(scene, 505);
  Simulation one = goOn(bytes, fine), two = goOn(bytes, fine, 3);
  ASSERT_EQ(one.advance(777), std::nullopt);
  const std::vector<std::byte> later = writeCheckpoint(one, fine, 3.0);
  EXPECT_EQ(two.particleSteps(), 505);
  EXPECT_EQ(checkpointMark(later)->step, 4 * 505 + 777);
  EXPECT_EQ(checkpointMark(later)->refinement, fine.refinement);
  Simulation three = goOn(later, fine);
  ASSERT_EQ(one.advance(1000), std::nullopt);
  ASSERT_EQ(two.advance(1777), std::nullopt);
  ASSERT_EQ(three.advance(1000), std::nullopt);
  EXPECT_EQ(two.stateHash(), one.stateHash());
  EXPECT_EQ(three.stateHash(), one.stateHash());
}

TEST(RetryResume, LongerStepsThanBeforeAreRefused) {
  const Scene scene = test::lowScene(60, 3.0), fine = refined(scene, {1, 0});
  const std::vector<std::byte> bytes = checkpointAfter(fine, 0);
  EXPECT_TRUE(readCheckpoint(bytes, refined(scene, {2, 1}), 1));
  const auto refused = readCheckpoint(bytes, scene, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.problems.front().message, "the checkpoint was taken with shorter steps");
}

/// What the end of a run says that may help.
std::optional<Refinement> cureOf(const Scene& scene) {
  Worker worker(scene);
  while (worker.next()) continue;
  EXPECT_EQ(worker.end().reason, EndReason::invalid);
  return worker.end().cure;
}

TEST(RetryWorker, TellsWhichStepsAreToBeHalved) {
  Scene gas = test::lowScene(0, 1e200);
  EXPECT_EQ(cureOf(gas), (Refinement{1, 1}));
  Scene contacts = test::lowScene(60, 3.0);
  contacts.limits.maxOverlap = 1e-3;
  contacts.start.arrangement = Arrangement::drop;
  EXPECT_EQ(cureOf(contacts), (Refinement{1, 0}));
  contacts.start.arrangement = Arrangement::settled;  // while it settles
  EXPECT_EQ(cureOf(contacts), (Refinement{1, 0}));
  contacts.particles.count = 100000;
  contacts.bed.top = BedTop::lid;  // no step finds room for them
  EXPECT_EQ(cureOf(contacts), std::nullopt);
}

}  // namespace
}  // namespace bedmix
