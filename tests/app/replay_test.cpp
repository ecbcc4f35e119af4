// SPDX-License-Identifier: MIT
#include "replay/csv.h"
#include "replay/trajectory_reader.h"
#include "tests/app/program.h"

#include <nlohmann/json.hpp>

#include <cstring>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

class ReplayPipeline : public ProgramTest {
 protected:
  void SetUp() override { record("r", "1"); }

  void record(const std::string& name, const std::string& seed) const {
    const Outcome run = bedmix({"run", "tiny", "-o", name, "--seed", seed});
    ASSERT_EQ(run.exitCode, 0) << run.err;
  }

  Table table(const std::string& file) const {
    const auto read = readCsv(folder / file);
    EXPECT_TRUE(read) << file;
    return read ? *read : Table{};
  }
};

TEST_F(ReplayPipeline, SeveralRunsAtOnceGiveWhatEachGivesAlone) {
  record("s", "2");
  record("t", "3");
  const Outcome all = bedmix({"replay", "r", "s", "t", "-o", "all", "--analysis", "temperature", "--json"});
  ASSERT_EQ(all.exitCode, 0) << all.err;
  const auto runs = nlohmann::json::parse(all.out)["runs"];
  ASSERT_EQ(runs.size(), 3u);
  for (const std::string run : {"r", "s", "t"}) {
    ASSERT_EQ(bedmix({"replay", run, "--analysis", "temperature"}).exitCode, 0);
    for (const std::string file : {"mixing.csv", "flux.csv", "pressure.csv", "temperature.csv"})
      EXPECT_EQ(readFile(folder / "all" / run / file), readFile(folder / run / "replay" / file))
          << run << file;
  }
  EXPECT_NE(readFile(folder / "all/s/mixing.csv"), readFile(folder / "all/t/mixing.csv"));
}

TEST_F(ReplayPipeline, RunThatCannotBeReadDoesNotKeepTheOthersFromBeingReplayed) {
  record("s", "2");
  fs::resize_file(folder / "s/trajectory.h5", 5000);
  const Outcome both = bedmix({"replay", "r", "s", "-o", "all"});
  EXPECT_EQ(both.exitCode, 4);
  EXPECT_TRUE(contains(both.err, "s/trajectory.h5"));
}

TEST_F(ReplayPipeline, JsonHoldsTheSeriesWithGapsAsNull) {
  const Outcome replay = bedmix({"replay", "r", "--json", "--min-particles", "60"});
  ASSERT_EQ(replay.exitCode, 0) << replay.err;
  const auto series = nlohmann::json::parse(replay.out)["series"];
  EXPECT_EQ(series["mixing"]["time"], nlohmann::json::parse("[0, 0.01, 0.02, 0.03, 0.04, 0.05]"));
  EXPECT_TRUE(series["mixing"]["lacey"][3].is_null());  // no cell holds all particles
  EXPECT_EQ(series["pressure"]["bed_height"].size(), 6u);
}

TEST_F(ReplayPipeline, TracerIsChosenByAnExpressionAtATime) {
  ASSERT_EQ(bedmix({"replay", "r", "-o", "left", "--tracer", "left-half"}).exitCode, 0);
  ASSERT_EQ(bedmix({"replay", "r", "-o", "x", "--tracer", "x < width/2"}).exitCode, 0);
  ASSERT_EQ(bedmix({"replay", "r", "-o", "strips", "--tracer", "strips=2"}).exitCode, 0);
  EXPECT_EQ(readFile(folder / "left/mixing.csv"), readFile(folder / "r/mixing.csv"));
  EXPECT_EQ(readFile(folder / "x/mixing.csv"), readFile(folder / "r/mixing.csv"));
  EXPECT_EQ(readFile(folder / "strips/mixing.csv"), readFile(folder / "r/mixing.csv"));

  // Two columns of cells, told apart at the end: unmixed there.
  const Outcome late =
      bedmix({"replay", "r", "-o", "late", "--tracer", "x < width/2", "--tracer-at", "0.05"});
  ASSERT_EQ(late.exitCode, 0) << late.err;
  EXPECT_LT(table("late/mixing.csv").find("lacey")->back().value(), 1e-12);
}

TEST_F(ReplayPipeline, ExpressionThatIsNoneIsRefused) {
  const Outcome replay = bedmix({"replay", "r", "--tracer", "x <"});
  EXPECT_EQ(replay.exitCode, 2);
  EXPECT_TRUE(contains(replay.err, "--tracer: \"x <\""));
  const Outcome late = bedmix({"replay", "r", "--tracer", "x", "--tracer-at", "3"});
  EXPECT_EQ(late.exitCode, 2);
  EXPECT_TRUE(contains(late.err, "--tracer-at"));
}

TEST_F(ReplayPipeline, RunComputedAgainIsTheSame) {
  for (const auto& more : {std::vector<std::string>{}, {"--from", "0"}}) {
    std::vector<std::string> words{"replay", "r", "--verify", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome verified = bedmix(words);
    ASSERT_EQ(verified.exitCode, 0) << verified.err;
    const auto told = nlohmann::json::parse(verified.out);
    EXPECT_EQ(told["same"], true);
    EXPECT_EQ(told["frames"], 6);
    EXPECT_EQ(told["states"], 2);  // the checkpoint at the end, and the hash in the summary
  }
  ASSERT_EQ(bedmix({"run", "settling", "-o", "plain", "--until", "0.03"}).exitCode, 0);
  EXPECT_EQ(bedmix({"replay", "plain", "--verify"}).exitCode, 0);
}

TEST_F(ReplayPipeline, FirstStepThatIsAnotherIsNamed) {
  const fs::path file = folder / "r/trajectory.h5";
  auto reader = TrajectoryReader::open(file);
  ASSERT_TRUE(reader);
  const FramePtr third = *reader->frame(3);
  std::string bytes = readFile(file);
  const std::string position(reinterpret_cast<const char*>(&third->position[7]), sizeof(Vec2f));
  const std::size_t at = bytes.find(position);
  ASSERT_NE(at, std::string::npos);
  bytes[at] = static_cast<char>(bytes[at] ^ 1);  // the last bit of x
  writeFile(file, bytes);

  const Outcome verified = bedmix({"replay", "r", "--verify", "--json"});
  EXPECT_EQ(verified.exitCode, 4);
  EXPECT_TRUE(contains(verified.err, "step 3000 at 0.03 s is the first")) << verified.err;
  EXPECT_TRUE(contains(verified.err, "x of particle 7 is"));
  EXPECT_EQ(nlohmann::json::parse(verified.out)["mismatch"]["step"], 3000);
}

}  // namespace
}  // namespace bedmix
