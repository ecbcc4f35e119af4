// SPDX-License-Identifier: MIT
#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

namespace bedmix::test {
namespace {

class EventLog : public ::testing::Test {
 protected:
  std::vector<RunEvent> read() const {
    const auto reader = TrajectoryReader::open(path);
    EXPECT_TRUE(reader) << toString(reader.problems.front());
    return reader ? reader->events() : std::vector<RunEvent>{};
  }

  Scene scene = syntheticScene(true, true);
  TemporaryFolder folder;
  std::filesystem::path path = folder / "trajectory.h5";
  const RunEvent first{0.25, "retry", "from 0.125 s with time.step = 5e-06"},
      second{0.5, "resume", "à la main"};
};

TEST_F(EventLog, IsEmptyWhereNothingHappened) {
  record(path, scene, 3);
  EXPECT_TRUE(read().empty());
}

TEST_F(EventLog, GivesBackWhatWasNotedAndOutlivesFrames) {
  {
    auto writer = TrajectoryWriter::create(path, scene, {"0.1.0", "abc"});
    ASSERT_TRUE(writer);
    for (int i = 0; i < 5; ++i) writer->accept(syntheticFrame(scene, i));
    writer->note(first);
    ASSERT_FALSE(writer->failure());
  }
  EXPECT_EQ(read(), std::vector{first});
  {
    auto writer = TrajectoryWriter::resume(path, scene, 2, 0);
    ASSERT_TRUE(writer) << toString(writer.problems.front());
    writer->note(second);
    writer->finish();
    ASSERT_FALSE(writer->failure());
  }
  EXPECT_EQ(read(), (std::vector{first, second}));
  EXPECT_EQ(playBack(path, scene).frames, 2u);
}

TEST_F(EventLog, CutsWhatIsTooLongBetweenCharacters) {
  auto writer = TrajectoryWriter::create(path, scene, {"0.1.0", "abc"});
  ASSERT_TRUE(writer);
  writer->accept(syntheticFrame(scene, 0));
  std::string text(479, 'x');
  writer->note({1.0, std::string(40, 'k'), text + "\u00e9"});
  writer->note({1.0, "", text + "y"});
  ASSERT_FALSE(writer->failure());
  EXPECT_EQ(read(), (std::vector<RunEvent>{{1.0, std::string(32, 'k'), text}, {1.0, "", text + "y"}}));
}

}  // namespace
}  // namespace bedmix::test
