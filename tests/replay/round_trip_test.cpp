// SPDX-License-Identifier: MIT
#include "engine/core/scene_reader.h"
#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

namespace bedmix::test {
namespace {

class RoundTrip : public testing::TestWithParam<std::tuple<bool, bool>> {};

TEST_P(RoundTrip, GivesBackEveryBit) {
  const auto [gas, friction] = GetParam();
  const Scene scene = syntheticScene(gas, friction);
  const TemporaryFolder folder;
  {
    auto writer = TrajectoryWriter::create(folder / "trajectory.h5", scene, {"0.1.0", "abc"});
    ASSERT_TRUE(writer) << toString(writer.problems.front());
    for (int i = 0; i < 150; ++i) writer->accept(syntheticFrame(scene, i));
    ASSERT_FALSE(writer->failure()) << toString(*writer->failure());
  }
  auto reader = TrajectoryReader::open(folder.path());
  ASSERT_TRUE(reader) << toString(reader.problems.front());
  EXPECT_EQ(writeScene(reader->scene()), writeScene(scene));
  EXPECT_EQ(reader->scene().name, scene.name);
  ASSERT_EQ(reader->times().size(), 150u);
  for (int i = 0; i < 150; ++i) {
    const FramePtr frame = reader->next();
    ASSERT_TRUE(frame) << toString(*reader->failure());
    EXPECT_TRUE(sameBits(*frame, syntheticFrame(scene, i))) << "frame " << i;
    EXPECT_EQ(reader->times()[static_cast<std::size_t>(i)], frame->time);
  }
  EXPECT_FALSE(reader->next());
  EXPECT_FALSE(reader->failure());
  for (int i : {77, 0, 149, 3}) {
    auto frame = reader->frame(static_cast<std::size_t>(i));
    ASSERT_TRUE(frame);
    EXPECT_TRUE(sameBits(**frame, syntheticFrame(scene, i)));
  }
}

INSTANTIATE_TEST_SUITE_P(Effects, RoundTrip, testing::Combine(testing::Bool(), testing::Bool()));

}  // namespace
}  // namespace bedmix::test
