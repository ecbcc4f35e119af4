// SPDX-License-Identifier: MIT
#include "engine/core/scene_reader.h"
#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

namespace bedmix::test {
namespace {

/// With gas, friction, heat, feed.
class RoundTrip : public testing::TestWithParam<std::tuple<bool, bool, bool, bool>> {};

TEST_P(RoundTrip, GivesBackEveryBit) {
  const auto [gas, friction, heat, feed] = GetParam();
  Scene scene = syntheticScene(gas, friction);
  if (heat) addHeat(scene);
  if (feed) addFeed(scene);
  const TemporaryFolder folder;
  record(folder / "trajectory.h5", scene, 150);

  EXPECT_EQ(playBack(folder.path(), scene).frames, 150u);  // a run folder
  auto reader = TrajectoryReader::open(folder / "trajectory.h5");
  ASSERT_TRUE(reader) << toString(reader.problems.front());
  EXPECT_EQ(writeScene(reader->scene()), writeScene(scene));
  EXPECT_EQ(reader->scene().name, scene.name);
  for (std::size_t i : {77u, 0u, 149u, 3u}) {
    const auto frame = reader->frame(i);
    ASSERT_TRUE(frame);
    EXPECT_TRUE(sameBits(**frame, syntheticFrame(scene, static_cast<int>(i))));
    EXPECT_EQ(reader->times()[i], (*frame)->time);
  }
}

INSTANTIATE_TEST_SUITE_P(Effects, RoundTrip,
                         testing::Combine(testing::Bool(), testing::Bool(), testing::Bool(),
                                          testing::Bool()));

TEST(RoundTrip, KeepsAContent) {
  for (const bool feed : {false, true}) {
    Scene scene = syntheticScene(true, true);
    scene.effects.at<ReactionSettings>().emplace().rate = 1.0;
    if (feed) addFeed(scene);
    const TemporaryFolder folder;
    record(folder / "trajectory.h5", scene, 20);
    EXPECT_EQ(playBack(folder.path(), scene).frames, 20u);
  }
}

TEST(RoundTrip, ManyFramesSplitTheTreesOfChunks) {
  const Scene scene = syntheticScene(true, false, 3);
  const TemporaryFolder folder;
  record(folder / "trajectory.h5", scene, 5000);
  EXPECT_EQ(playBack(folder.path(), scene).frames, 5000u);
}

TEST(RoundTrip, KeepsABedWithoutParticles) {
  const Scene scene = syntheticScene(true, true, 0);
  const TemporaryFolder folder;
  record(folder / "trajectory.h5", scene, 5);
  EXPECT_EQ(playBack(folder.path(), scene).frames, 5u);
}

TEST(RoundTrip, ReadsWhileTheRunGoesOn) {
  const Scene scene = syntheticScene(true, true);
  const TemporaryFolder folder;
  auto writer = TrajectoryWriter::create(folder / "trajectory.h5", scene, {"0.1.0", "abc"});
  ASSERT_TRUE(writer);
  for (int i = 0; i < 140; ++i) {
    writer->accept(syntheticFrame(scene, i));
    if (i % 10 > 0) continue;
    EXPECT_EQ(playBack(folder.path(), scene).frames, static_cast<std::size_t>(i + 1));
  }
}

TEST(RoundTrip, SameFramesMakeTheSameFile) {
  const Scene scene = syntheticScene(true, true);
  const TemporaryFolder folder;
  record(folder / "a.h5", scene, 20);
  record(folder / "b.h5", scene, 20);
  EXPECT_EQ(fileText(folder / "a.h5"), fileText(folder / "b.h5"));
}

}  // namespace
}  // namespace bedmix::test
