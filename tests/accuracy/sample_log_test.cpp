// SPDX-License-Identifier: MIT
#include "app/accuracy/sample_log.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <unistd.h>

namespace fs = std::filesystem;

namespace bedmix {
namespace {

class Log : public testing::Test {
 protected:
  Log() : folder_(fs::temp_directory_path() / ("bedmix_log_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~Log() override { fs::remove_all(folder_); }

  SampleLog open(bool resume, const std::string& version = "1 (abc)",
                 const std::string& scene = "f00d") const {
    Result<SampleLog> log = SampleLog::open(file(), version, scene, resume);
    EXPECT_TRUE(log) << log.problems[0].message;
    return std::move(*log);
  }
  fs::path file() const { return folder_ / "accuracy.csv"; }
  std::string text() const {
    std::ifstream in(file(), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder_;
};

Sample sample(int index) {
  Sample s{{Panel::trajectory, "gas.grid.columns=[[4,0.024]] a=\"b\"", "accuracy=reference", index}, {}, {}};
  s.set(measure::position, 0.1 + index);
  s.set(measure::horizon, 1.0 / 3.0);
  return s;
}

TEST_F(Log, GivesBackWhatItWasGiven) {
  Sample failed = sample(2);
  failed.failure = "particle 3 overlaps, \"far\" too much";
  {
    SampleLog log = open(false);
    EXPECT_FALSE(log.add(sample(1)));
    EXPECT_FALSE(log.add(failed));
  }
  const SampleLog log = open(true);
  ASSERT_EQ(log.samples().size(), 2u);
  EXPECT_EQ(log.samples()[0].key, sample(1).key);
  EXPECT_EQ(log.samples()[0].values, sample(1).values);
  EXPECT_EQ(log.samples()[1].failure, failed.failure);
}

TEST_F(Log, GoesOnAfterALineThatWasCut) {
  {
    SampleLog log = open(false);
    EXPECT_FALSE(log.add(sample(1)));
    EXPECT_FALSE(log.add(sample(2)));
  }
  const std::string whole = text();
  fs::resize_file(file(), whole.size() - 5);
  {
    SampleLog log = open(true);
    EXPECT_EQ(log.samples().size(), 1u);
    EXPECT_FALSE(log.add(sample(2)));
  }
  EXPECT_EQ(text(), whole);
}

TEST_F(Log, SamplesOfOtherVersionsAndScenesAreKeptButNotTaken) {
  {
    SampleLog log = open(false);
    EXPECT_FALSE(log.add(sample(1)));
  }
  EXPECT_TRUE(open(true, "2 (def)").samples().empty());
  EXPECT_TRUE(open(true, "1 (abc)", "beef").samples().empty());
  EXPECT_EQ(open(true).samples().size(), 1u);
}

TEST_F(Log, FilesThatAreNoneAreRefused) {
  EXPECT_FALSE(SampleLog::open(file(), "1", "2", true));  // none there
  std::ofstream(file()) << "time,lacey\n0,1\n";
  const auto foreign = SampleLog::open(file(), "1", "2", true);
  ASSERT_FALSE(foreign);
  EXPECT_EQ(foreign.problems[0].trouble, Trouble::file);
  open(false);
  std::ofstream(file(), std::ios::app) << "1,2,no panel,s,,0,\n";
  const auto damaged = SampleLog::open(file(), "1", "2", true);
  ASSERT_FALSE(damaged);
  EXPECT_EQ(damaged.problems[0].at.line, 2);
}

}  // namespace
}  // namespace bedmix
