// SPDX-License-Identifier: MIT
#include "replay/summary.h"

#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

namespace bedmix::test {
namespace {

RunSummary someSummary() {
  RunSummary s;
  s.scene = "tian-2007-even";
  s.seed = 0xffffffffffffffffull;
  s.version = "0.1.0";
  s.commit = "abcdef0";
  s.simulatedSeconds = 10.0;
  s.wallSeconds = 19.25;
  s.steps = 1000000;
  s.gasSteps = 100000;
  s.particleStepsPerSecond = 5.1e7;
  s.stages = {{"neighbours", 1.5}, {"drag", 0.1}, {"contacts", 2.25}};
  s.threads = 4;
  s.simd = "avx2";
  s.stateHash = 0x00c0ffee;
  s.endReason = "stopped";
  s.retries = {{3.25, 3.0, "the gas has no finite solution", {{"time.step", 5e-6}, {"gas.step", 5e-5}}},
               {3.5, 3.0, "particle 3 overlaps", {{"time.step", 2.5e-6}, {"gas.step", 5e-5}}}};
  return s;
}

TEST(Summary, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  const RunSummary written = someSummary();
  ASSERT_FALSE(writeSummary(folder / "summary.json", written, syntheticScene(true, true)));
  const auto read = readSummary(folder / "summary.json");
  ASSERT_TRUE(read) << toString(read.problems.front());
  EXPECT_EQ(read->scene, written.scene);
  EXPECT_EQ(read->seed, written.seed);
  EXPECT_EQ(read->version, written.version);
  EXPECT_EQ(read->commit, written.commit);
  EXPECT_EQ(read->simulatedSeconds, written.simulatedSeconds);
  EXPECT_EQ(read->wallSeconds, written.wallSeconds);
  EXPECT_EQ(read->steps, written.steps);
  EXPECT_EQ(read->gasSteps, written.gasSteps);
  EXPECT_EQ(read->particleStepsPerSecond, written.particleStepsPerSecond);
  EXPECT_EQ(read->stages, written.stages);
  EXPECT_EQ(read->threads, written.threads);
  EXPECT_EQ(read->simd, written.simd);
  EXPECT_EQ(read->stateHash, written.stateHash);
  EXPECT_EQ(read->endReason, written.endReason);
  EXPECT_EQ(read->retries, written.retries);
}

TEST(Summary, NamesEveryResolvedSetting) {
  const TemporaryFolder folder;
  ASSERT_FALSE(writeSummary(folder / "summary.json", someSummary(), syntheticScene(true, false)));
  const std::string text = fileText(folder / "summary.json");
  for (const char* part :
       {"\"state_hash\": \"0000000000c0ffee\"", "\"simulated_seconds\": 10.0",
        "\"integrator\": \"velocity-verlet\"", "\"velocity_umf\": 2.0", "\"restitution\": 0.9",
        "\"min_particles\": 5", "\"title\": \"Grains à la \\\"carte\\\"\""})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
  EXPECT_EQ(text.find("friction"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "summary.json.part"));
}

TEST(Summary, SaysWhatIsWrongWithAFile) {
  const TemporaryFolder folder;
  EXPECT_FALSE(readSummary(folder / "missing.json"));
  writeText(folder / "broken.json", "{\"scene\": ");
  writeText(folder / "other.json", "{\"scene\": \"x\"}");
  for (const char* name : {"broken.json", "other.json"}) {
    const auto read = readSummary(folder / name);
    ASSERT_FALSE(read);
    EXPECT_NE(toString(read.problems.front()).find("is not a summary of a bedmix run"), std::string::npos);
  }
}

TEST(Summary, LeavesNothingWhereItCannotBeWritten) {
  const TemporaryFolder folder;
  writeText(folder / "file", "kept");
  const auto problem =
      writeSummary(folder / "file/summary.json", someSummary(), syntheticScene(false, false));
  ASSERT_TRUE(problem);
  EXPECT_NE(toString(*problem).find("Not a directory"), std::string::npos);
  EXPECT_EQ(fileText(folder / "file"), "kept");
}

}  // namespace
}  // namespace bedmix::test
