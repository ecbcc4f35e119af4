// SPDX-License-Identifier: MIT
#include "replay/trajectory_reader.h"
#include "tests/app/program.h"

#include <csignal>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

// What a run meets around it beside its own files: streams, signals, folders.

class FaultsAround : public ProgramTest {
 protected:
  void expectWhole(const std::string& run) const {
    const auto reader = TrajectoryReader::open(folder / run);
    ASSERT_TRUE(reader) << toString(reader.problems.front());
    EXPECT_EQ(reader->times().size(), 6u);
    ASSERT_EQ(bedmix({"replay", run}).exitCode, 0);
    EXPECT_EQ(readFile(folder / run / "mixing.csv"), readFile(folder / run / "replay/mixing.csv"));
  }
};

TEST_F(FaultsAround, ClosedStreamsAreNoTrouble) {
  for (const std::string streams : {"<&-", ">&-", "2>&-", "<&- >&- 2>&-"}) {
    fs::remove_all(folder / "r");
    EXPECT_EQ(shell("\"$BEDMIX\" run tiny -o r --json " + streams).exitCode, 0) << streams;
    expectWhole("r");
  }
}

TEST_F(FaultsAround, FullStreamsOfMessagesAreNoTroubleThoseOfDataAre) {
  EXPECT_EQ(shell("\"$BEDMIX\" run tiny -o r 2> /dev/full").exitCode, 0);
  expectWhole("r");
  for (const std::string command : {"run tiny -o s --json", "check tiny", "scenes"}) {
    const Outcome o = shell("\"$BEDMIX\" " + command + " > /dev/full");
    EXPECT_EQ(o.exitCode, 4) << command;
    EXPECT_TRUE(contains(o.err, "error: stdout: No space left on device"));
  }
  expectWhole("s");
}

TEST_F(FaultsAround, FolderOfASystemThatCannotBeWrittenTo) {
  for (const std::string path : {"/sys/kernel", "/proc/sys", "/sys/kernel/r"}) {
    const Outcome o = bedmix({"run", "tiny", "-o", path, "--force"});
    EXPECT_EQ(o.exitCode, 4) << path;
    EXPECT_TRUE(contains(o.err, "error: " + path));
  }
}

// The second SIGTERM kills, so that the run is ended in the middle of what the first makes it do.
TEST_F(FaultsAround, StormOfSignalsLosesNothing) {
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "whole", "--until", "2"}).exitCode, 0);
  for (int round = 0; round < 5; ++round) {
    const auto run = start({"run", "tiny", "-o", "r", "--until", "2", round == 0 ? "--force" : "--resume"});
    ASSERT_TRUE(run->waitForMessage(" s of 2 s"));
    for (int i = 0; i < 500; ++i) {
      run->send(SIGUSR1);
      if (i % 100 == 99 - round) run->send(i % 200 < 100 ? SIGINT : SIGTERM);
    }
    const int code = run->wait().exitCode;
    EXPECT_TRUE(code == 130 || code == 128 + SIGINT || code == 128 + SIGTERM || code == 0) << code;
  }
  ASSERT_EQ(bedmix({"run", "tiny", "-o", "r", "--until", "2", "--resume"}).exitCode, 0);
  EXPECT_EQ(readFile(folder / "r/mixing.csv"), readFile(folder / "whole/mixing.csv"));
}

}  // namespace
}  // namespace bedmix
