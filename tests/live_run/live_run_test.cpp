// SPDX-License-Identifier: MIT
#include "engine/live_run.h"

#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

namespace bedmix {
namespace {

using Clock = std::chrono::steady_clock;

Scene smallBed(double velocity = 3.0) {
  Scene scene = test::lowScene(60, velocity);
  scene.start.arrangement = Arrangement::drop;
  scene.sampling.interval = 0.005;
  return scene;
}

/// A run and who waits for its news.
class Watched {
 public:
  explicit Watched(const Scene& scene, Pace pace = Pace::free) : run(scene, 1, pace, [this] { arrived(); }) {}

  /// The first snapshot of which it holds; null after 30 s.
  template <class Predicate>
  SnapshotPtr waitFor(const Predicate& holds) {
    std::unique_lock lock(mutex_);
    SnapshotPtr found;
    news_.wait_for(lock, std::chrono::seconds(30), [&] {
      found = run.newest();
      return holds(*found);
    });
    return holds(*found) ? found : nullptr;
  }
  SnapshotPtr waitForStep(std::int64_t step) {
    return waitFor([&](const Snapshot& s) { return s.frame && s.frame->step >= step; });
  }

 private:
  void arrived() {
    const std::lock_guard lock(mutex_);
    news_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable news_;

 public:
  LiveRun run;
};

class Notes : public FrameTap {
 public:
  void accept(const FramePtr& frame) override {
    if (delay.count() > 0) std::this_thread::sleep_for(delay);
    frames.push_back(frame);
    log.push_back(std::to_string(frame->step));
  }
  void note(const Steering& steering) override { log.push_back(steering.kind + " " + steering.detail); }

  std::chrono::milliseconds delay{0};
  std::vector<FramePtr> frames;
  std::vector<std::string> log;
};

double meanHeight(const Frame& frame) {
  double sum = 0.0;
  for (const Vec2f at : frame.position) sum += at.y;
  return sum / static_cast<double>(frame.size());
}

TEST(LiveRun, BeginsAtRestWithTheArrangedBed) {
  const Scene scene = test::lowScene(60, 3.0);
  Watched live(scene);
  ASSERT_NE(live.run.newest(), nullptr);
  ASSERT_NE(live.run.newest()->scene, nullptr);
  const SnapshotPtr first = live.waitForStep(0);
  ASSERT_NE(first, nullptr);
  EXPECT_FALSE(first->isPlaying);
  EXPECT_EQ(first->frame->position, test::simulate(scene).frame()->position);
}

TEST(LiveRun, PlaysPausesAndSteps) {
  Watched live(smallBed());
  live.run.play(true);
  ASSERT_NE(live.waitForStep(1500), nullptr);
  live.run.play(false);
  const SnapshotPtr paused = live.waitFor([](const Snapshot& s) { return !s.isPlaying; });
  ASSERT_NE(paused, nullptr);
  EXPECT_EQ(paused->speed, 0.0);
  live.run.step();
  const SnapshotPtr stepped = live.waitForStep(paused->frame->step + 500);
  ASSERT_NE(stepped, nullptr);
  EXPECT_EQ(stepped->frame->step, paused->frame->step + 500);
  EXPECT_FALSE(stepped->isPlaying);
  EXPECT_EQ(stepped->speed, 0.0);
  EXPECT_GT(stepped->number, paused->number);
}

TEST(LiveRun, GoesOnBeyondTheDurationAndMeasuresItsSpeed) {
  Scene scene = smallBed();
  scene.time.duration = 0.01;
  Watched live(scene);
  live.run.play(true);
  const SnapshotPtr beyond = live.waitForStep(2500);
  ASSERT_NE(beyond, nullptr);
  EXPECT_GT(beyond->speed, 0.0);
}

TEST(LiveRun, RestartArrangesTheSteeredSceneAnew) {
  Watched live(smallBed());
  live.run.step();
  live.run.change({{"gravity", "5.0"}});
  live.run.tagTracer(TracerRule::lowerHalf);
  live.run.step();
  ASSERT_NE(live.waitForStep(1000), nullptr);
  live.run.restart();
  ASSERT_NE(live.waitFor([](const Snapshot& s) { return s.frame && s.frame->step == 0; }), nullptr);
  EXPECT_EQ(live.run.newest()->scene->gravity, 5.0);
  Scene steered = smallBed();
  steered.gravity = 5.0;
  steered.tracer.rule = TracerRule::lowerHalf;
  live.run.step();
  const SnapshotPtr later = live.waitForStep(500);
  ASSERT_NE(later, nullptr);
  Simulation plain = test::simulate(steered);
  ASSERT_EQ(plain.advance(500), std::nullopt);
  EXPECT_EQ(later->frame->position, plain.frame()->position);
  EXPECT_EQ(later->frame->species, plain.frame()->species);
}

TEST(LiveRun, ASpeedLimitIsKeptAndYieldsToOrders) {
  Watched live(smallBed());
  ASSERT_NE(live.waitForStep(0), nullptr);
  live.run.limitSpeed(0.1);  // 50 ms a frame
  live.run.play(true);
  const Clock::time_point start = Clock::now();
  ASSERT_NE(live.waitForStep(1500), nullptr);
  EXPECT_GE(std::chrono::duration<double>(Clock::now() - start).count(), 0.09);
  live.run.limitSpeed(1e-9);
  live.run.play(false);  // waits for no frame
  EXPECT_NE(live.waitFor([](const Snapshot& s) { return !s.isPlaying; }), nullptr);
  live.run.limitSpeed(std::numeric_limits<double>::infinity());
  live.run.play(true);
  EXPECT_NE(live.waitForStep(4000), nullptr);
}

TEST(LiveRun, NewestNeverWaits) {
  Watched live(smallBed());
  Notes slow;
  slow.delay = std::chrono::milliseconds(300);
  ASSERT_NE(live.waitForStep(0), nullptr);
  live.run.setTap(&slow);
  live.run.play(true);
  ASSERT_NE(live.waitFor([](const Snapshot& s) { return s.isPlaying; }), nullptr);
  const Clock::time_point start = Clock::now();
  for (int i = 0; i < 1000; ++i) EXPECT_NE(live.run.newest(), nullptr);
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - start).count(), 0.2);
  live.run.setTap(nullptr);
}

TEST(LiveRun, TapGetsEveryFrameInOrderHoweverSlow) {
  Watched live(smallBed());
  Notes tap;
  tap.delay = std::chrono::milliseconds(5);
  live.run.play(true);
  ASSERT_NE(live.waitForStep(500), nullptr);
  live.run.setTap(&tap);
  ASSERT_NE(live.waitForStep(live.run.newest()->frame->step + 5500), nullptr);
  live.run.setTap(nullptr);
  const std::size_t taken = tap.frames.size();
  ASSERT_GE(taken, 11u);
  const std::int64_t first = tap.frames.front()->step;
  for (std::size_t i = 0; i < taken; ++i)
    EXPECT_EQ(tap.frames[i]->step, first + 500 * static_cast<std::int64_t>(i));
  ASSERT_NE(live.waitForStep(live.run.newest()->frame->step + 1000), nullptr);
  EXPECT_EQ(tap.frames.size(), taken);
}

TEST(LiveRun, TapThatIsThereBeforeTheBedGetsItsFirstFrame) {
  Notes tap;
  {
    Watched live(test::lowScene(60, 3.0));
    live.run.setTap(&tap);
    ASSERT_NE(live.waitForStep(0), nullptr);
  }
  EXPECT_EQ(tap.log, std::vector<std::string>{"0"});
}

TEST(LiveRun, TapIsToldWhatWasDone) {
  Watched live(smallBed(), Pace::ticked);
  Notes tap;
  live.run.setTap(&tap);
  live.run.tick();
  live.run.step();
  live.run.change({{"gas.inlets.0.velocity", "2.5"}, {"gravity", "9"}});
  live.run.change({{"bed.width", "1"}});  // refused: nothing was done
  live.run.tagTracer(TracerRule::upperHalf);
  live.run.step();
  live.run.restart();
  live.run.step();
  live.run.tick();
  EXPECT_EQ(tap.log,
            (std::vector<std::string>{"0", "500", "set gas.inlets.0.velocity = 2.5", "set gravity = 9",
                                      "tracer upper-half", "1000", "restart ", "0", "500"}));
}

TEST(LiveRun, RefusedChangesSayWhyAndChangeNothing) {
  Watched live(smallBed(), Pace::ticked);
  live.run.change({{"gravity", "5"}, {"bed.width", "1"}});
  live.run.tick();
  EXPECT_EQ(
      live.run.newest()->refusal,
      "--set bed.width: bed.width is fixed while a run goes on: the walls and the cells of the gas have "
      "been built of it");
  EXPECT_EQ(live.run.newest()->scene->gravity, 9.81);
  live.run.step();
  live.run.tick();
  EXPECT_NE(live.run.newest()->refusal, "");
  live.run.change({{"gravity", "5"}});
  live.run.tick();
  EXPECT_EQ(live.run.newest()->refusal, "");
  EXPECT_EQ(live.run.newest()->scene->gravity, 5.0);
}

TEST(LiveRun, RetaggingColoursThePresentFrame) {
  Watched live(smallBed(), Pace::ticked);
  live.run.play(true);
  for (int frame = 0; frame < 10; ++frame) live.run.tick();
  const SnapshotPtr before = live.run.newest();
  live.run.play(false);
  live.run.tagTracer(TracerRule::rightHalf);
  live.run.tick();
  const SnapshotPtr after = live.run.newest();
  EXPECT_EQ(after->frame->position, before->frame->position);
  EXPECT_EQ(after->scene->tracer.rule, TracerRule::rightHalf);
  for (std::size_t i = 0; i < after->frame->size(); ++i)
    EXPECT_EQ(after->frame->species[i] == 1, after->frame->position[i].x >= 0.024f) << i;
}

TEST(LiveRun, MoreGasRaisesTheBed) {
  Watched live(test::lowScene(60, 0.0), Pace::ticked);
  live.run.step();
  live.run.tick();
  const double atRest = meanHeight(*live.run.newest()->frame);
  live.run.change({{"gas.inlets.0.velocity", "4.0"}});
  live.run.play(true);
  for (int frame = 0; frame < 15; ++frame) live.run.tick();
  EXPECT_EQ(live.run.newest()->frame->step, 16000);
  EXPECT_GT(meanHeight(*live.run.newest()->frame), 1.5 * atRest);
}

TEST(LiveRun, TroubleLeavesARunThatCanBeMendedAndRestarted) {
  Watched live(smallBed());
  live.run.play(true);
  ASSERT_NE(live.waitForStep(500), nullptr);
  live.run.change({{"gas.inlets.0.velocity", "1e200"}});
  const SnapshotPtr broken = live.waitFor([](const Snapshot& s) { return !s.trouble.empty(); });
  ASSERT_NE(broken, nullptr);
  EXPECT_FALSE(broken->isPlaying);
  ASSERT_NE(broken->frame, nullptr);

  live.run.play(true);
  live.run.step();
  live.run.restart();  // with what has broken it
  live.run.play(true);
  ASSERT_NE(
      live.waitFor([&](const Snapshot& s) { return s.number > broken->number + 4 && !s.trouble.empty(); }),
      nullptr);
  live.run.change({{"gas.inlets.0.velocity", "3.0"}});
  live.run.restart();
  live.run.play(true);
  const SnapshotPtr mended =
      live.waitFor([](const Snapshot& s) { return s.trouble.empty() && s.frame && s.frame->step >= 1000; });
  ASSERT_NE(mended, nullptr);
  EXPECT_TRUE(mended->isPlaying);
}

TEST(LiveRun, BedsThatCannotBeArrangedSaySo) {
  Scene scene = test::lowScene(60, 3.0);
  scene.limits.maxOverlap = 1e-9;
  Watched live(scene);
  const SnapshotPtr broken = live.waitFor([](const Snapshot& s) { return !s.trouble.empty(); });
  ASSERT_NE(broken, nullptr);
  EXPECT_EQ(broken->frame, nullptr);
  live.run.tagTracer(TracerRule::upperHalf);
  live.run.change({{"limits.max_overlap", "0.1"}});
  live.run.restart();
  EXPECT_NE(live.waitForStep(0), nullptr);
}

struct Scripted {
  std::vector<FramePtr> frames;
  std::uint64_t stateHash = 0;
};
Scripted script() {
  Watched live(smallBed(), Pace::ticked);
  Notes tap;
  live.run.setTap(&tap);
  live.run.play(true);
  for (int frame = 1; frame <= 20; ++frame) {
    if (frame == 5) live.run.change({{"gas.inlets.0.velocity", "4"}});
    if (frame == 9) live.run.change({{"gravity", "7"}, {"gas.drag", "ergun"}});
    if (frame == 12) live.run.tagTracer(TracerRule::lowerHalf);
    live.run.tick();
  }
  live.run.setTap(nullptr);
  return {tap.frames, live.run.newest()->stateHash};
}

TEST(LiveRun, TickedRunsOfOneScriptAreTheSame) {
  const Scripted one = script(), other = script();
  EXPECT_EQ(one.stateHash, other.stateHash);
  ASSERT_EQ(one.frames.size(), 21u);
  ASSERT_EQ(other.frames.size(), 21u);
  for (std::size_t i = 0; i < 21; ++i) {
    EXPECT_EQ(one.frames[i]->position, other.frames[i]->position) << i;
    EXPECT_EQ(one.frames[i]->species, other.frames[i]->species) << i;
    EXPECT_EQ(one.frames[i]->gas.pressure, other.frames[i]->gas.pressure) << i;
  }
}

TEST(LiveRun, ATickedRunIsTheSimulationAndNothingElse) {
  Watched live(smallBed(), Pace::ticked);
  Simulation plain = test::simulate(smallBed());
  live.run.tick();
  EXPECT_EQ(live.run.newest()->frame->step, 0);  // nobody has said play
  live.run.play(true);
  EXPECT_FALSE(live.run.newest()->isPlaying);  // nor has it been carried out
  for (int frame = 0; frame < 10; ++frame) {
    live.run.tick();
    ASSERT_EQ(plain.advance(500), std::nullopt);
    EXPECT_EQ(live.run.newest()->stateHash, plain.stateHash());
  }
  EXPECT_EQ(live.run.newest()->speed, 0.0);
}

TEST(LiveRun, EndsWhilePlaying) {
  const Clock::time_point start = Clock::now();
  for (const bool settles : {false, true}) {
    Scene scene = smallBed();
    if (settles) scene.start.arrangement = Arrangement::settled;
    LiveRun run(scene, 2, Pace::free);
    run.limitSpeed(1e-6);
    run.play(true);
    run.step();
    run.play(true);
  }
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - start).count(), 20.0);
}

}  // namespace
}  // namespace bedmix
