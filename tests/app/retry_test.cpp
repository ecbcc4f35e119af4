// SPDX-License-Identifier: MIT
#include "engine/core/refinement.h"
#include "engine/worker.h"
#include "replay/summary.h"
#include "replay/trajectory_reader.h"
#include "tests/app/program.h"

#include <csignal>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

/// The gas shoots a sphere up: at 4 m/s it moves half its diameter in a step, at 8 m/s in half a step.
constexpr const char* shot = R"(
[bed]
width = 0.048
height = 0.6
thickness = 0.004
[particles]
count = 1
diameter = 0.004
density = 1500.0
[contacts]
stiffness = 20.0
restitution = 0.9
[time]
duration = 0.2
step = 5e-4
[start]
arrangement = "drop"
[gas]
step = 1e-3
[gas.grid]
columns = [[2, 0.024]]
rows = [[20, 0.03]]
[[gas.inlets]]
from = 0.0
to = 0.048
velocity = 30.0
[sampling]
columns = 2
rows = 6
min_particles = 1
interval = 0.01
)";

class FaultsRetry : public ProgramTest {
 protected:
  FaultsRetry() { writeFile(folder / "shot.toml", shot); }

  Outcome run(const std::string& name, const std::string& until, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", "shot.toml", "-o", name, "--until", until});
    return bedmix(more);
  }
  RunSummary summaryOf(const std::string& name) const {
    auto summary = readSummary(folder / name / "summary.json");
    EXPECT_TRUE(summary);
    return summary ? *summary : RunSummary{};
  }
  TrajectoryReader open(const std::string& name) const {
    auto reader = TrajectoryReader::open(folder / name);
    EXPECT_TRUE(reader) << toString(reader.problems.front());
    return std::move(*reader);
  }
  /// Expects that a run left frames and series in order, and that a replay gives the same series.
  void expectWhole(const std::string& name, double end) const {
    TrajectoryReader reader = open(name);
    const std::vector<double>& times = reader.times();
    for (std::size_t i = 0; i < times.size(); ++i)
      EXPECT_EQ(times[i], static_cast<double>(i) / 100.0) << "each interval once";
    EXPECT_EQ(times.back(), end);
    ASSERT_EQ(bedmix({"replay", name}).exitCode, 0);
    for (const char* csv : {"mixing.csv", "pressure.csv"})
      EXPECT_EQ(readFile(folder / name / csv), readFile(folder / name / "replay" / csv));
  }
};

TEST_F(FaultsRetry, IsNotDoneUnlessAskedFor) {
  const Outcome o = run("r", "0.2");
  EXPECT_EQ(o.exitCode, 3);
  EXPECT_TRUE(contains(o.err, "of its diameter in a step"));
  EXPECT_TRUE(summaryOf("r").retries.empty());
}

TEST_F(FaultsRetry, GoesBackToTheLastCheckpointAndSaysSo) {
  ASSERT_EQ(run("r", "0.05").exitCode, 0);  // with a checkpoint at its end
  const Outcome o = run("r", "0.2", {"--resume", "--on-trouble", "retry"});
  ASSERT_EQ(o.exitCode, 0) << o.err;
  EXPECT_TRUE(contains(o.err, "warning: retry from 0.05 s with time.step = 0.00025: particle 0 moves "));
  const RunSummary s = summaryOf("r");
  EXPECT_EQ(s.endReason, "finished");
  ASSERT_EQ(s.retries.size(), 1u);
  EXPECT_GT(s.retries[0].time, 0.05);
  EXPECT_EQ(s.retries[0].from, 0.05);
  EXPECT_TRUE(contains(s.retries[0].reason, "use a smaller time.step"));
  EXPECT_EQ(s.retries[0].settings, (std::vector<std::pair<std::string, double>>{{"time.step", 2.5e-4}}));
  const std::vector<RunEvent> events = open("r").events();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].kind, "resume");
  EXPECT_EQ(events[0].time, 0.05);
  EXPECT_TRUE(contains(events[0].detail, "by bedmix "));
  EXPECT_EQ(events[1].kind, "retry");
  EXPECT_EQ(events[1].time, s.retries[0].time);
  EXPECT_TRUE(contains(events[1].detail, "from 0.05 s with time.step = 0.00025: particle 0 moves "));
  expectWhole("r", 0.2);
  EXPECT_TRUE(contains(bedmix({"replay", "r"}).err, "retry from 0.05 s with time.step = 0.00025"));
}

TEST_F(FaultsRetry, IsTheRunThatGoesOnByHandWithHalfTheStep) {
  ASSERT_EQ(run("r", "0.05").exitCode, 0);
  std::vector<std::vector<std::byte>> checkpoints = open("r").checkpoints();
  ASSERT_EQ(run("r", "0.2", {"--resume", "--on-trouble", "retry", "--threads", "2"}).exitCode, 0);

  TrajectoryReader retried = open("r");
  const Scene half = refined(retried.scene(), {1, 0});
  auto start = readCheckpoint(checkpoints.at(1), half, 1);  // of frame 5; the other one's is the first
  ASSERT_TRUE(start) << start.problems.front().message;
  ASSERT_EQ(start->simulation.time(), 0.05);
  Worker byHand(half, std::move(*start), std::nullopt);
  std::size_t index = 6;
  while (const FramePtr expected = byHand.next()) {
    const auto frame = retried.frame(index++);
    ASSERT_TRUE(frame);
    EXPECT_EQ((*frame)->step, expected->step);
    EXPECT_EQ((*frame)->time, expected->time);
    EXPECT_EQ((*frame)->position, expected->position);
    EXPECT_EQ((*frame)->velocity, expected->velocity);
    EXPECT_EQ((*frame)->gas.velocity, expected->gas.velocity);
  }
  EXPECT_EQ(index, retried.times().size());
  EXPECT_EQ(byHand.end().stateHash, summaryOf("r").stateHash);
}

TEST_F(FaultsRetry, WhatIsResumedLaterKeepsTheShorterSteps) {
  ASSERT_EQ(run("whole", "0.3", {"--on-trouble", "retry"}).exitCode, 0);
  EXPECT_EQ(summaryOf("whole").retries.at(0).from, 0.0);
  ASSERT_EQ(run("r", "0.15", {"--on-trouble", "retry"}).exitCode, 0);
  const Outcome rest = run("r", "0.3", {"--resume"});
  ASSERT_EQ(rest.exitCode, 0) << rest.err;
  EXPECT_TRUE(contains(rest.err, "going on from 0.15 s with time.step = 0.00025"));
  EXPECT_EQ(summaryOf("r").stateHash, summaryOf("whole").stateHash);
  EXPECT_EQ(readFile(folder / "r/mixing.csv"), readFile(folder / "whole/mixing.csv"));
  expectWhole("r", 0.3);
}

TEST_F(FaultsRetry, KilledInARetryItComesToTheSameRun) {
  ASSERT_EQ(run("whole", "3", {"--on-trouble", "retry"}).exitCode, 0);
  for (const std::string name : {"r0", "r1", "r2"}) {
    const auto killed = start({"run", "shot.toml", "-o", name, "--until", "3", "--on-trouble", "retry"});
    ASSERT_TRUE(killed->waitForMessage("retry from 0 s"));
    if (name != "r0") {
      ASSERT_TRUE(killed->waitForMessage(name == "r1" ? "\n   0.010 s" : "\n   0.6"));
    }
    killed->send(SIGKILL);
    killed->wait();
    const Outcome rest = run(name, "3", {"--resume", "--on-trouble", "retry"});
    ASSERT_EQ(rest.exitCode, 0) << rest.err;
    EXPECT_EQ(summaryOf(name).stateHash, summaryOf("whole").stateHash) << name;
    EXPECT_EQ(readFile(folder / name / "mixing.csv"), readFile(folder / "whole/mixing.csv")) << name;
  }
}

TEST_F(FaultsRetry, FilmIsThatOfTheFramesThatCount) {
  ASSERT_EQ(run("r", "0.2", {"--on-trouble", "retry", "--video"}).exitCode, 0);
  ASSERT_EQ(bedmix({"render", "r", "-o", "again.mp4"}).exitCode, 0);
  EXPECT_TRUE(readFile(folder / "r/video.mp4") == readFile(folder / "again.mp4"));
}

TEST_F(FaultsRetry, WhereItDoesNotHelpTheRunEndsAndTellsAll) {
  for (const std::string arrangement : {"drop", "settled"}) {  // trouble at once: back to the start
    const Outcome o =
        bedmix({"run", "tiny", "-o", arrangement, "--set", "start.arrangement=" + arrangement, "--set",
                "limits.max_overlap=8e-4", "--set", "limits.warn_overlap=1e-4", "--on-trouble", "retry"});
    EXPECT_EQ(o.exitCode, 3);
    for (const char* part :
         {"retry from 0 s with time.step = 5e-06: ", "retry from 0 s with time.step = 2.5e-06: ",
          "; 3 retries did not help, the last from 0 s with time.step = 1.25e-06"})
      EXPECT_TRUE(contains(o.err, part));
    const RunSummary s = summaryOf(arrangement);
    EXPECT_EQ(s.endReason, "invalid");
    EXPECT_EQ(s.retries.size(), 3u);
  }
}

TEST_F(FaultsRetry, OptionIsChecked) {
  const Outcome o = run("r", "0.2", {"--on-trouble", "hope"});
  EXPECT_EQ(o.exitCode, 2);
  EXPECT_TRUE(contains(o.err, "--on-trouble"));
}

}  // namespace
}  // namespace bedmix
