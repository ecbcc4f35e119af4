// SPDX-License-Identifier: MIT
#include "tests/app/program.h"

#include <nlohmann/json.hpp>

#include <csignal>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

// All threads of the program at once: solver and its team, recorder, series, painters, encoder, checkpoints,
// signals. In the preset tsan a race among them ends the program with exit code 66.
class Live : public ProgramTest {};

TEST_F(Live, FilmedRunOnThreeThreadsTakesSignalsAndGoesOn) {
  const auto tiny = [](const std::string& run, const std::string& until, std::vector<std::string> more) {
    more.insert(more.begin(), {"run", "tiny", "-o", run, "--until", until, "--set", "time.step=5e-5", "--set",
                               "start.arrangement=drop"});
    return more;
  };
  const auto summaryOf = [this](const std::string& run) {
    return nlohmann::json::parse(readFile(folder / run / "summary.json"));
  };

  const std::vector<std::string> live{"--video", "--threads", "3", "--checkpoint", "0"};
  const auto run = start(tiny("r", "1000", live));
  ASSERT_TRUE(run->waitForMessage("0.000 s of 1000 s"));
  run->send(SIGUSR1);
  run->send(SIGTERM);
  const Outcome stopped = run->wait();
  ASSERT_EQ(stopped.exitCode, 130) << stopped.err;
  EXPECT_GT(fs::file_size(folder / "r/video.mp4"), 1000u);

  const std::string until = std::to_string(summaryOf("r")["simulated_seconds"].get<double>() + 0.1);
  std::vector<std::string> andResume = live;
  andResume.push_back("--resume");
  const Outcome resumed = bedmix(tiny("r", until, andResume));
  ASSERT_EQ(resumed.exitCode, 0) << resumed.err;
  const Outcome whole = bedmix(tiny("whole", until, {"--threads", "1"}));
  ASSERT_EQ(whole.exitCode, 0) << whole.err;
  EXPECT_EQ(summaryOf("r")["state_hash"], summaryOf("whole")["state_hash"]);
  EXPECT_EQ(readFile(folder / "r/mixing.csv"), readFile(folder / "whole/mixing.csv"));
}

}  // namespace
}  // namespace bedmix
