// SPDX-License-Identifier: MIT
#include "engine/core/rng.h"
#include "replay/trajectory_writer.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace bedmix::test {
namespace {

/// What a program leaves that records frames as fast as it can and is killed at any moment. It reports that
/// it has begun and each frame that is written, a byte into a pipe.
struct Killed {
  int reported = -1;  // frames
  Playback left;
};

Killed recordAndKill(const std::vector<Frame>& frames, const Scene& scene, int framesBeforeKill,
                     int systemCalls) {
  const TemporaryFolder folder;
  int reports[2];
  EXPECT_EQ(pipe(reports), 0);
  const pid_t child = fork();
  if (child == 0) {
    auto writer = TrajectoryWriter::create(folder / "trajectory.h5", scene, {"0.1.0", "abc"});
    const auto report = [&] { return !writer->failure() && write(reports[1], "", 1) == 1; };
    bool goesWell = writer && report();
    for (std::size_t i = 0; goesWell && i < frames.size(); ++i) {
      writer->accept(frames[i]);
      goesWell = report();
    }
    if (goesWell) pause();
    _exit(1);
  }
  close(reports[1]);
  Killed killed;
  char byte;
  while (killed.reported < framesBeforeKill && read(reports[0], &byte, 1) == 1) ++killed.reported;
  for (int i = 0; i < systemCalls; ++i) getppid();  // so that it is hit in any phase of a frame
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the recording ended before it was killed";
  while (read(reports[0], &byte, 1) == 1) ++killed.reported;
  close(reports[0]);
  killed.left = playBack(folder / "trajectory.h5", scene);
  return killed;
}

TEST(Crash, KilledAtAnyMomentNoReportedFrameIsLost) {
  const Scene scene = syntheticScene(true, true);
  std::vector<Frame> frames;
  for (int i = 0; i < 3000; ++i) frames.push_back(syntheticFrame(scene, i));
  Rng rng(9);
  for (int trial = 0; trial < 100; ++trial) {
    const int before = 1 + static_cast<int>(rng.next() % 150);
    const Killed killed = recordAndKill(frames, scene, before, static_cast<int>(rng.next() % 5000));
    const auto reported = static_cast<std::size_t>(killed.reported);
    EXPECT_GE(killed.left.frames, reported) << "trial " << trial << ": " << killed.left.message;
    EXPECT_LE(killed.left.frames, reported + 1) << "trial " << trial;
  }
}

TEST(Crash, KilledBeforeTheFirstFrameSaysSo) {
  const Scene scene = syntheticScene(true, true);
  const Killed killed = recordAndKill({}, scene, 0, 0);
  EXPECT_EQ(killed.left.frames, 0u);
  EXPECT_FALSE(killed.left.message.empty());
}

}  // namespace
}  // namespace bedmix::test
