// SPDX-License-Identifier: MIT
#include "engine/core/rng.h"
#include "replay/csv.h"
#include "replay/trajectory_reader.h"
#include "tests/app/program.h"

#include <nlohmann/json.hpp>

#include <csignal>
#include <unistd.h>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

class FaultsResume : public ProgramTest {
 protected:
  /// Runs tiny; what else is given comes behind.
  Outcome runTiny(const std::string& run, const std::string& until,
                  std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"run", "tiny", "-o", run, "--until", until});
    return bedmix(more);
  }
  nlohmann::json summaryOf(const std::string& run) const {
    return nlohmann::json::parse(readFile(folder / run / "summary.json"));
  }
  std::vector<FramePtr> framesOf(const std::string& run) const {
    auto reader = TrajectoryReader::open(folder / run);
    EXPECT_TRUE(reader);
    std::vector<FramePtr> frames;
    while (FramePtr frame = reader->next()) frames.push_back(frame);
    return frames;
  }

  /// Expects that a run left the same results as one without a break.
  void expectSameRun(const std::string& run, const std::string& whole) const {
    for (const char* csv : {"mixing.csv", "flux.csv", "pressure.csv"})
      EXPECT_TRUE(readFile(folder / run / csv) == readFile(folder / whole / csv)) << run << ' ' << csv;
    const auto is = summaryOf(run), expected = summaryOf(whole);
    for (const char* key :
         {"settings", "simulated_seconds", "steps", "gas_steps", "state_hash", "end_reason"})
      EXPECT_EQ(is[key], expected[key]) << run;
    const auto frames = framesOf(run), those = framesOf(whole);
    ASSERT_EQ(frames.size(), those.size()) << run;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      EXPECT_EQ(frames[i]->step, those[i]->step);
      EXPECT_EQ(frames[i]->position, those[i]->position) << run << ", frame " << i;
      EXPECT_EQ(frames[i]->velocity, those[i]->velocity);
      EXPECT_EQ(frames[i]->angularVelocity, those[i]->angularVelocity);
      EXPECT_EQ(frames[i]->gas.voidage, those[i]->gas.voidage);
      EXPECT_EQ(frames[i]->gas.pressure, those[i]->gas.pressure);
      EXPECT_EQ(frames[i]->gas.velocity, those[i]->gas.velocity);
    }
  }

  /// Inverts a byte in the middle of checkpoints; `which` of those in the file, or all for -1.
  void damageCheckpoint(const std::string& run, int which) const {
    const fs::path path = folder / run / "trajectory.h5";
    std::string bytes = readFile(path);
    int k = 0;
    for (std::size_t at = 0; (at = bytes.find("!bedmckp", at)) != std::string::npos; at += 500, ++k)
      if (which < 0 || which == k) bytes[at + 400] = static_cast<char>(~bytes[at + 400]);
    EXPECT_EQ(k, 2);
    writeFile(path, bytes);
  }
};

TEST_F(FaultsResume, PicturesMayChange) {
  ASSERT_EQ(runTiny("r", "0.02").exitCode, 0);
  const Outcome o = runTiny("r", "0.03", {"--resume", "--set", "pictures.color=speed"});
  EXPECT_EQ(o.exitCode, 0) << o.err;
}

TEST_F(FaultsResume, KilledAgainAndAgainItComesToTheSameRun) {
  ASSERT_EQ(runTiny("whole", "4").exitCode, 0);
  const std::uintmax_t all = fs::file_size(folder / "whole/mixing.csv");
  Rng rng(3);
  int kills = 0;
  for (int round = 0; round < 5; ++round) {
    const std::string name = "r" + std::to_string(round);
    const fs::path mixing = folder / name / "mixing.csv";
    bool begun = false;
    for (int k = 1; k <= 5; ++k) {
      std::vector<std::string> arguments{"run",
                                         "tiny",
                                         "-q",
                                         "-o",
                                         name,
                                         "--until",
                                         "4",
                                         "--checkpoint",
                                         "0",
                                         "--threads",
                                         k % 2 == 0 ? "2" : "1"};
      if (begun) arguments.push_back("--resume");
      const auto run = start(arguments);
      // Either early, or when it has come on a good deal; then at any moment of a frame.
      const std::uintmax_t far = k % 2 == 0 ? 100 : all * static_cast<std::uintmax_t>(k) / 6;
      std::error_code none;
      for (int look = 0; look < 30000000; ++look)
        if (fs::exists(mixing, none) && fs::file_size(mixing, none) >= far) break;
      for (std::uint64_t spin = rng.next() % 3000; spin > 0; --spin) getppid();
      run->send(SIGKILL);
      if (run->wait().exitCode == 128 + SIGKILL) ++kills;
      begun = true;
      const auto reader = TrajectoryReader::open(folder / name);
      ASSERT_TRUE(reader) << toString(reader.problems.at(0));
      const auto table = readCsv(mixing);
      EXPECT_GE(reader->times().size(), table ? table->rows() : 0) << "a row follows its frame";
    }
    const Outcome end = runTiny(name, "4", {"--resume"});
    ASSERT_EQ(end.exitCode, 0) << end.err;
    EXPECT_TRUE(contains(end.err, "going on from"));
    expectSameRun(name, "whole");
  }
  EXPECT_GE(kills, 20);
}

TEST_F(FaultsResume, StoppedBySignalItGoesOn) {
  ASSERT_EQ(runTiny("whole", "2").exitCode, 0);
  const auto run = start({"run", "tiny", "-o", "r", "--until", "2"});
  ASSERT_TRUE(run->waitForMessage("\n   0.4"));
  for (int i = 0; i < 200; ++i) run->send(SIGUSR1);
  ASSERT_TRUE(run->waitForMessage("\n   0.6"));
  run->send(SIGTERM);
  ASSERT_EQ(run->wait().exitCode, 130);
  const double stopped = summaryOf("r")["simulated_seconds"];
  EXPECT_GE(stopped, 0.6);
  const Outcome rest = runTiny("r", "2", {"--resume"});
  ASSERT_EQ(rest.exitCode, 0) << rest.err;
  EXPECT_TRUE(contains(rest.err, "going on from " + nlohmann::json(stopped).dump() + " s"));
  expectSameRun("r", "whole");
}

TEST_F(FaultsResume, RunThatHasEndedGoesOnWhereMoreIsAskedFor) {
  ASSERT_EQ(runTiny("whole", "0.2").exitCode, 0);
  ASSERT_EQ(runTiny("r", "0.055").exitCode, 0);  // between two frames, the last of which it drops again
  EXPECT_EQ(framesOf("r").size(), 7u);
  ASSERT_EQ(runTiny("r", "0.055", {"--resume"}).exitCode, 0);  // nothing changes
  EXPECT_EQ(framesOf("r").size(), 7u);
  ASSERT_EQ(runTiny("r", "0.1", {"--resume"}).exitCode, 0);
  fs::remove(folder / "r/summary.json");
  fs::remove(folder / "r/flux.csv");
  ASSERT_EQ(runTiny("r", "0.2", {"--resume"}).exitCode, 0);
  expectSameRun("r", "whole");
  const Outcome earlier = runTiny("r", "0.1", {"--resume"});
  EXPECT_EQ(earlier.exitCode, 0);
  EXPECT_TRUE(contains(earlier.err, "has come to 0.2 s already"));
  expectSameRun("r", "whole");
}

TEST_F(FaultsResume, FilmIsThatOfTheWholeRun) {
  ASSERT_EQ(runTiny("whole", "0.1", {"--video"}).exitCode, 0);
  ASSERT_EQ(runTiny("r", "0.04").exitCode, 0);
  ASSERT_EQ(runTiny("r", "0.1", {"--resume", "--video"}).exitCode, 0);
  EXPECT_TRUE(readFile(folder / "r/video.mp4") == readFile(folder / "whole/video.mp4"));
}

TEST_F(FaultsResume, DamagedCheckpointIsRefusedAndTheOlderOneUsed) {
  ASSERT_EQ(runTiny("whole", "0.2").exitCode, 0);
  for (int which = 0; which < 2; ++which) {
    const std::string name = "r" + std::to_string(which);
    ASSERT_EQ(runTiny(name, "0.1").exitCode, 0);
    damageCheckpoint(name, which);
    const Outcome o = runTiny(name, "0.2", {"--resume"});
    ASSERT_EQ(o.exitCode, 0) << o.err;
    EXPECT_TRUE(contains(o.err, "one checkpoint is not whole"));
    expectSameRun(name, "whole");
  }
  ASSERT_EQ(runTiny("r", "0.1").exitCode, 0);
  damageCheckpoint("r", -1);
  const std::string before = readFile(folder / "r/mixing.csv");
  const Outcome o = runTiny("r", "0.2", {"--resume"});
  EXPECT_EQ(o.exitCode, 4);
  EXPECT_TRUE(contains(o.err, "no checkpoint to go on from; start it anew with --force"));
  EXPECT_EQ(readFile(folder / "r/mixing.csv"), before);
}

TEST_F(FaultsResume, FullDiskThenRoomGoesOn) {
  const auto run = start({"run", "tiny", "-o", "r", "--until", "1000", "--checkpoint", "0"});
  ASSERT_TRUE(run->waitForMessage("0.000 s of 1000 s"));
  run->fillDisk(200 << 10);
  const Outcome full = run->wait();
  ASSERT_EQ(full.exitCode, 4) << full.err;
  const std::string until = std::to_string(framesOf("r").back()->time + 0.2);
  const Outcome rest = runTiny("r", until, {"--resume"});
  ASSERT_EQ(rest.exitCode, 0) << rest.err;
  ASSERT_EQ(runTiny("whole", until).exitCode, 0);
  expectSameRun("r", "whole");
}

TEST_F(FaultsResume, OnlyTheSameSceneIsGoneOnWith) {
  ASSERT_EQ(runTiny("r", "0.02").exitCode, 0);
  const auto refusal = [&](std::vector<std::string> more) {
    more.push_back("--resume");
    const Outcome o = runTiny("r", "0.03", more);
    EXPECT_EQ(o.exitCode, 2) << o.err;
    return o.err;
  };
  EXPECT_TRUE(contains(refusal({"--set", "contacts.stiffness=900"}),
                       "--resume: contacts.stiffness is 900.0, but 2000.0 in the recorded run"));
  EXPECT_TRUE(contains(refusal({"--seed", "2"}), "seed is 2, but 1 in the recorded run"));
  EXPECT_TRUE(contains(refusal({"--set", "gas="}), "in the recorded run, and missing here"));
  EXPECT_TRUE(contains(refusal({"--set", "floor.inclination_deg=5"}), "floor.inclination_deg is 5.0"));
  EXPECT_TRUE(contains(refusal({"--force"}), "--resume"));
}

TEST_F(FaultsResume, FolderWithoutARunIsRefused) {
  const Outcome o = runTiny("nowhere", "1", {"--resume"});
  EXPECT_EQ(o.exitCode, 4);
  EXPECT_TRUE(contains(o.err, "holds no run to go on with"));
  EXPECT_FALSE(fs::exists(folder / "nowhere"));
}

TEST_F(FaultsResume, TwoRunsIntoOneFolderAreRefused) {
  const auto run = start({"run", "tiny", "-o", "r", "--until", "1000"});
  ASSERT_TRUE(run->waitForMessage("0.000 s of 1000 s"));
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--force"}, {"--resume"}}) {
    const Outcome o = runTiny("r", "1000", more);
    EXPECT_EQ(o.exitCode, 4);
    EXPECT_TRUE(contains(o.err, "another bedmix is writing into this folder"));
  }
  run->send(SIGKILL);
  run->wait();
  EXPECT_EQ(runTiny("r", "0.05", {"--force"}).exitCode, 0);  // the lock went with it
}

TEST_F(FaultsResume, TrajectoryThatIsDeletedEndsTheRun) {
  const auto run = start({"run", "tiny", "-o", "r", "--until", "1000"});
  ASSERT_TRUE(run->waitForMessage("0.000 s of 1000 s"));
  fs::remove(folder / "r/trajectory.h5");
  const Outcome o = run->wait();
  EXPECT_EQ(o.exitCode, 4);
  EXPECT_TRUE(contains(o.err, "it has been deleted while it was being written"));
}

}  // namespace
}  // namespace bedmix
