// SPDX-License-Identifier: MIT
#include "engine/checkpoint.h"
#include "engine/core/hash.h"
#include "engine/core/rng.h"
#include "engine/worker.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace bedmix {
namespace {

/// Takes `steps` steps at once, or `before` of them, a checkpoint, and the rest elsewhere; both must come to
/// the same bits, and frames, and checkpoints.
void expectResumes(const Scene& scene, std::int64_t steps, std::int64_t before, int threadsBefore,
                   int threadsAfter) {
  Simulation whole = test::simulate(scene), first = test::simulate(scene, threadsBefore);
  ASSERT_EQ(whole.advance(steps), std::nullopt);
  ASSERT_EQ(first.advance(before), std::nullopt);
  const std::vector<std::byte> bytes = writeCheckpoint(first, scene, 12.5);
  EXPECT_EQ(checkpointMark(bytes)->step, before);
  auto resumed = readCheckpoint(bytes, scene, threadsAfter);
  ASSERT_TRUE(resumed) << resumed.problems.front().message;
  EXPECT_EQ(resumed->wallSeconds, 12.5);
  Simulation& second = resumed->simulation;
  EXPECT_EQ(second.stateHash(), first.stateHash());
  EXPECT_EQ(second.contacts(), first.contacts());
  EXPECT_EQ(writeCheckpoint(second, scene, 12.5), bytes);
  ASSERT_EQ(second.advance(steps - before), std::nullopt);

  EXPECT_EQ(second.stateHash(), whole.stateHash()) << before << " of " << steps << " steps";
  EXPECT_EQ(second.step(), steps);
  EXPECT_EQ(second.gasSteps(), whole.gasSteps());
  EXPECT_EQ(second.particleSteps(), whole.particleSteps());
  EXPECT_EQ(second.contacts(), whole.contacts());
  EXPECT_EQ(second.report().largestOverlap, whole.report().largestOverlap);
  EXPECT_EQ(second.report().largestOverlapParticle, whole.report().largestOverlapParticle);
  EXPECT_EQ(second.report().largestMassResidual, whole.report().largestMassResidual);
  const FramePtr a = second.frame(), b = whole.frame();
  EXPECT_EQ(a->position, b->position);
  EXPECT_EQ(a->angularVelocity, b->angularVelocity);
  EXPECT_EQ(a->species, b->species);
  EXPECT_EQ(a->gas.pressure, b->gas.pressure);
}

struct Effects {
  const char* name;
  Integrator integrator;
  bool friction;
  std::optional<GasScheme> gas;
};

class Resume : public ::testing::TestWithParam<Effects> {};

/// A bed that bubbles hard, so that lists are made anew several times; without gas, one that falls.
Scene sceneWith(const Effects& effects) {
  Scene scene = test::lowScene(60, 3.0);
  scene.time.integrator = effects.integrator;
  if (!effects.friction) scene.contacts.friction.reset();
  if (effects.gas) {
    scene.gas->scheme = *effects.gas;
  } else {
    scene.gas.reset();
    scene.start.arrangement = Arrangement::drop;
  }
  return scene;
}

TEST_P(Resume, GoesOnToTheBit) {
  const Scene scene = sceneWith(GetParam());
  for (const std::int64_t before : {0, 1, 1500, 3007}) expectResumes(scene, 6000, before, 1, 3);
}

INSTANTIATE_TEST_SUITE_P(
    Effects, Resume,
    ::testing::Values(Effects{"Verlet", Integrator::velocityVerlet, true, {}},
                      Effects{"VerletSmooth", Integrator::velocityVerlet, false, {}},
                      Effects{"VerletProjection", Integrator::velocityVerlet, true, GasScheme::projection},
                      Effects{"VerletSmoothSimple", Integrator::velocityVerlet, false, GasScheme::simple},
                      Effects{"Euler", Integrator::symplecticEuler, true, {}},
                      Effects{"Onset", Integrator::verletOnset, true, {}},
                      Effects{"OnsetSmooth", Integrator::verletOnset, false, {}},
                      Effects{"OnsetProjection", Integrator::verletOnset, true, GasScheme::projection},
                      Effects{"Rk4", Integrator::rk4, true, {}},
                      Effects{"Rk4SmoothProjection", Integrator::rk4, false, GasScheme::projection},
                      Effects{"Rk4Simple", Integrator::rk4, true, GasScheme::simple}),
    [](const auto& param) { return std::string(param.param.name); });

/// Steps that are chosen are cut where a call ends: a run is saved where frames do.
TEST(ResumeChosenSteps, GoesOnToTheBitAtFrames) {
  for (const bool gas : {true, false})
    for (const bool particles : {true, false}) {
      Scene scene = sceneWith({"", Integrator::verletOnset, true, GasScheme::projection});
      if (gas) scene.gas->step = StepLength::automatic();
      if (particles) scene.time.step = StepLength::automatic();
      for (const std::int64_t before : {0, 1, 4})
        expectResumes(scene, 6 * stepsPerFrame(scene), before * stepsPerFrame(scene), 1, 3);
    }
  Scene dry = sceneWith({"", Integrator::velocityVerlet, true, {}});
  dry.time.step = StepLength::automatic();
  expectResumes(dry, 6 * stepsPerFrame(dry), 2 * stepsPerFrame(dry), 1, 3);
}

/// A tube that turns over a floor that moves, with gas or without.
TEST(ResumeMovingWalls, GoesOnToTheBit) {
  for (const bool gas : {true, false})
    for (const Integrator integrator :
         {Integrator::velocityVerlet, Integrator::verletOnset, Integrator::rk4}) {
      Scene scene = sceneWith({"", integrator, true, {}});
      if (gas) scene.gas = test::lowScene(60, 3.0).gas;
      scene.floor.vibration = VibrationSettings{0.003, 30.0};
      scene.obstacles.emplace_back();
      ObstacleSettings& tube = scene.obstacles.back();
      tube.x = 0.024, tube.y = 0.05, tube.radius = 0.008, tube.spinRpm = 120.0;
      if (integrator == Integrator::rk4) {
        expectResumes(scene, 3000, 1507, 1, 1);
        continue;
      }
      expectResumes(scene, 6000, 3007, 1, 3);
      if (integrator != Integrator::verletOnset) continue;
      scene.time.step = StepLength::automatic();
      if (gas) scene.gas->step = StepLength::automatic();
      expectResumes(scene, 6 * stepsPerFrame(scene), 2 * stepsPerFrame(scene), 1, 3);
    }
}

Scene largeScene() {
  Scene scene = test::paperScene(2.6);
  scene.bed.width = 0.48;
  scene.bed.height = 1.32;
  scene.gravity = 200.0;  // falls into contact at once
  scene.limits.maxOverlap = 0.4;
  scene.particles.count = 9000;
  scene.gas->grid.columns = {{40, 0.012}};
  scene.gas->grid.rows = {{110, 0.012}};
  scene.gas->inlets = {{0.0, 0.48, 2.6, std::nullopt}};
  scene.start.arrangement = Arrangement::drop;
  return scene;
}

/// Several blocks, contacts across them, and a gas grid that is solved by iteration and shared by threads.
TEST(ResumeLarge, GoesOnToTheBitOnAnyThreads) {
  Scene scene = largeScene();
  expectResumes(scene, 1000, 505, 1, 3);
  expectResumes(scene, 1000, 700, 3, 1);
  scene.time.step = scene.gas->step = StepLength::automatic();
  expectResumes(scene, stepsPerFrame(scene), 0, 1, 3);
}

TEST(ResumeChanges, InletsThatWereChangedStayChanged) {
  const Scene scene = test::lowScene(60, 3.0);
  std::vector<Inlet> stronger = scene.gas->inlets;
  stronger[0].velocity = 4.0;
  Simulation whole = test::simulate(scene);
  ASSERT_EQ(whole.advance(100), std::nullopt);
  whole.setInlets(stronger);
  auto resumed = readCheckpoint(writeCheckpoint(whole, scene, 0.0), scene, 1);
  ASSERT_TRUE(resumed);
  ASSERT_EQ(whole.advance(1000), std::nullopt);
  ASSERT_EQ(resumed->simulation.advance(1000), std::nullopt);
  EXPECT_EQ(resumed->simulation.stateHash(), whole.stateHash());
}

TEST(ResumeWorker, HandsOutTheRemainingFrames) {
  Scene scene = test::lowScene(60, 2.6);
  scene.time.duration = 0.025;  // ends between two frames
  const CheckpointSchedule always{.wallSeconds = 0.0, .simulatedSeconds = 0.0};
  std::vector<FramePtr> frames;
  std::vector<Checkpoint> checkpoints;
  Worker whole(scene, 1, always);
  while (FramePtr frame = whole.next()) {
    frames.push_back(frame);
    if (Checkpoint c = whole.checkpoint()) checkpoints.push_back(c);
    EXPECT_EQ(whole.checkpoint(), nullptr);
  }
  ASSERT_EQ(frames.size(), 4u);
  ASSERT_GE(checkpoints.size(), 2u);
  EXPECT_EQ(checkpointMark(*checkpoints.front())->step, 0);
  EXPECT_EQ(checkpointMark(*checkpoints.back())->step, 2500);

  Scene longer = scene;
  longer.time.duration = 0.04;
  Worker one(longer, 1);
  std::vector<FramePtr> all;
  while (FramePtr frame = one.next()) all.push_back(frame);
  for (const Checkpoint& c : checkpoints) {
    auto from = readCheckpoint(*c, longer, 2);
    ASSERT_TRUE(from);
    std::size_t next = static_cast<std::size_t>(checkpointMark(*c)->step / stepsPerFrame(scene)) + 1;
    Worker rest(longer, std::move(*from), std::nullopt);
    for (; FramePtr frame = rest.next(); ++next) {
      ASSERT_LT(next, all.size());
      EXPECT_EQ(frame->step, all[next]->step);
      EXPECT_EQ(frame->position, all[next]->position);
    }
    EXPECT_EQ(next, all.size());
    EXPECT_EQ(rest.end().stateHash, one.end().stateHash);
    EXPECT_EQ(rest.end().steps, 4000);
  }
}

TEST(ResumeWorker, ComesWithACheckpointWhereItIsStopped) {
  Scene scene = test::lowScene(60, 2.6);
  scene.time.duration = 1000.0;
  Worker worker(scene, 1, CheckpointSchedule{1e9, 1e9});
  FramePtr last = worker.next();
  ASSERT_NE(worker.checkpoint(), nullptr);
  worker.requestStop();
  Checkpoint checkpoint;
  while (FramePtr frame = worker.next()) last = frame, checkpoint = worker.checkpoint();
  ASSERT_NE(checkpoint, nullptr);
  EXPECT_EQ(checkpointMark(*checkpoint)->step, last->step);
}

TEST(ResumeWorker, ComesWithACheckpointWhereOneIsAskedFor) {
  Scene scene = test::lowScene(60, 2.6);
  scene.time.duration = 1000.0;
  Worker worker(scene, 1, CheckpointSchedule{1e9, 1e9});
  worker.next();
  ASSERT_NE(worker.checkpoint(), nullptr);
  worker.requestCheckpoint();
  Checkpoint checkpoint;
  for (int i = 0; i < 30 && !checkpoint; ++i) {
    worker.next();
    checkpoint = worker.checkpoint();
  }
  EXPECT_NE(checkpoint, nullptr);
}

class DamagedCheckpoint : public ::testing::Test {
 protected:
  DamagedCheckpoint() {
    Simulation simulation = test::simulate(scene);
    EXPECT_EQ(simulation.advance(300), std::nullopt);
    sound = writeCheckpoint(simulation, scene, 1.0);
  }
  /// Why it is refused.
  std::string refusal(const std::vector<std::byte>& bytes) const {
    const auto resumed = readCheckpoint(bytes, scene, 1);
    return resumed ? "" : resumed.problems.front().message;
  }

  Scene scene = test::lowScene(60, 2.6);
  std::vector<std::byte> sound;
};

TEST_F(DamagedCheckpoint, SoundOneIsTakenAndMayBeFollowedByMore) {
  EXPECT_EQ(refusal(sound), "");
  std::vector<std::byte> longer = sound;
  longer.resize(sound.size() + 1000);
  EXPECT_EQ(refusal(longer), "");
}

TEST_F(DamagedCheckpoint, CutOffAnywhereIsRefused) {
  for (std::size_t percent = 0; percent < 100; ++percent) {
    std::vector<std::byte> cut = sound;
    cut.resize(sound.size() * percent / 100);
    EXPECT_EQ(refusal(cut), "the checkpoint is cut off") << percent << " %";
    cut.resize(sound.size());  // zeros, as of a file that was made longer and not written
    EXPECT_NE(refusal(cut), "") << percent << " %";
    EXPECT_FALSE(checkpointMark(cut));
  }
}

TEST_F(DamagedCheckpoint, AnyFlippedBitIsRefused) {
  Rng rng(5);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<std::byte> flipped = sound;
    const std::uint64_t bit =
        trial < 400 ? static_cast<std::uint64_t>(trial) : rng.next() % (8 * sound.size());
    flipped[bit / 8] ^= std::byte{1} << bit % 8;
    EXPECT_NE(refusal(flipped), "") << "bit " << bit;
  }
}

/// Whoever recomputes the checksum may write anything: it is refused or goes on, but never crashes.
TEST_F(DamagedCheckpoint, NonsenseUnderARightChecksumDoesNoHarm) {
  Rng rng(6);
  int refused = 0;
  constexpr int trials = 500;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<std::byte> forged = sound;
    const std::size_t header = 64, at = header + rng.next() % (sound.size() - header - 16);
    const std::size_t many = 1 + rng.next() % 8;
    for (std::size_t k = 0; k < many; ++k) forged[at + k] = static_cast<std::byte>(rng.next());
    StateHash hash;
    hash.add(std::span<const std::byte>(forged).first(forged.size() - 8));
    const std::uint64_t sum = hash.value();
    std::copy_n(reinterpret_cast<const std::byte*>(&sum), 8, forged.end() - 8);
    auto resumed = readCheckpoint(forged, scene, 1);
    if (resumed)
      (void)resumed->simulation.advance(50);
    else
      ++refused;
  }
  EXPECT_GT(refused, 20);
}

TEST_F(DamagedCheckpoint, AnotherSceneIsRefusedAnotherDurationIsNot) {
  scene.time.duration *= 2.0;
  EXPECT_EQ(refusal(sound), "");
  *scene.contacts.stiffness *= 2.0;
  EXPECT_EQ(refusal(sound), "the checkpoint is of another scene");
}

TEST_F(DamagedCheckpoint, AnotherVersionIsRefused) {
  sound[8] ^= std::byte{0x40};
  EXPECT_NE(refusal(sound).find("of version 67, this bedmix reads 3"), std::string::npos) << refusal(sound);
}

}  // namespace
}  // namespace bedmix
