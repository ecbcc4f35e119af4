// SPDX-License-Identifier: MIT
#include "replay/hdf5_handle.h"
#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

namespace bedmix::test {
namespace {

std::vector<std::byte> filled(std::size_t size, int value) {
  return std::vector<std::byte>(size, static_cast<std::byte>(value));
}

/// The first `size` bytes of a checkpoint.
std::vector<std::byte> first(std::vector<std::byte> bytes, std::size_t size) {
  bytes.resize(size);
  return bytes;
}

/// Rows of a dataset.
hsize_t rowsOf(const std::filesystem::path& path, const char* name) {
  const H5 file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "open");
  const H5 dataset(H5Dopen2(file, name, H5P_DEFAULT), "open");
  const H5 space(H5Dget_space(dataset), "open");
  hsize_t extent[3] = {};
  H5Sget_simple_extent_dims(space, extent, nullptr);
  return extent[0];
}

class ResumedTrajectory : public ::testing::Test {
 protected:
  /// Goes on after `kept` frames until there are `all`.
  void goOn(
      int kept, int all, const std::function<void(TrajectoryWriter&)>& before = [](auto&) {}) {
    auto writer = TrajectoryWriter::resume(path, scene, static_cast<std::size_t>(kept), 0);
    ASSERT_TRUE(writer) << toString(writer.problems.front());
    before(*writer);
    for (int i = kept; i < all; ++i) writer->accept(syntheticFrame(scene, i));
    writer->finish();
    ASSERT_FALSE(writer->failure()) << toString(*writer->failure());
  }

  Scene scene = syntheticScene(true, true);
  TemporaryFolder folder;
  std::filesystem::path path = folder / "trajectory.h5";
};

TEST_F(ResumedTrajectory, KeepsTheLastTwoCheckpointsOfAnyLength) {
  auto writer = TrajectoryWriter::create(path, scene, {"0.1.0", "abc"});
  ASSERT_TRUE(writer);
  writer->accept(syntheticFrame(scene, 0));
  EXPECT_TRUE(TrajectoryReader::open(path)->checkpoints().at(0).empty());
  for (const auto& [size, value] : {std::pair{70000u, 1}, {3u, 2}, {9000u, 3}, {90000u, 4}, {10u, 5}})
    writer->keep(filled(size, value));
  ASSERT_FALSE(writer->failure());
  const auto found = TrajectoryReader::open(path)->checkpoints();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(first(found[0], 10), filled(10, 5));
  EXPECT_EQ(first(found[1], 90000), filled(90000, 4));
}

TEST_F(ResumedTrajectory, GoesOnAfterTheFramesThatAreKept) {
  record(path, scene, 150);
  for (const int kept : {150, 149, 130, 128, 100, 64, 63, 1}) {
    goOn(kept, kept + 3);
    EXPECT_EQ(playBack(path, scene).frames, static_cast<std::size_t>(kept + 3));
    for (const char* name : {"particles/all/position/value", "particles/all/velocity/time",
                             "observables/lacey/value", "bedmix/gas/voidage/value"})
      EXPECT_EQ(rowsOf(path, name), static_cast<hsize_t>(kept + 3)) << name;
  }
}

TEST_F(ResumedTrajectory, LaterFramesStayWhereTheyComeOutTheSame) {
  record(path, scene, 20);
  auto writer = TrajectoryWriter::resume(path, scene, 10, 0);
  ASSERT_TRUE(writer);
  for (int i = 10; i < 15; ++i) {
    writer->accept(syntheticFrame(scene, i));
    EXPECT_EQ(playBack(path, scene).frames, 20u);
  }
  Frame other = syntheticFrame(scene, 15);
  other.position[7].x = std::nextafter(other.position[7].x, 1.0f);
  writer->accept(other);
  EXPECT_FALSE(writer->failure());
  auto reader = TrajectoryReader::open(path);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->times().size(), 16u);
  EXPECT_TRUE(sameBits(**reader->frame(15), other));
}

TEST_F(ResumedTrajectory, HoldsWhatARunAtOnceHolds) {
  record(path, scene, 90);
  goOn(70, 200);
  const auto whole = folder / "whole.h5";
  record(whole, scene, 200);
  EXPECT_EQ(playBack(path, scene).frames, 200u);
  for (const char* name : {"observables/lacey/value", "observables/pressure_drop/value"}) {
    std::vector<double> values[2];
    for (int k = 0; k < 2; ++k) {
      const H5 file(H5Fopen((k == 0 ? path : whole).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "open");
      const H5 dataset(H5Dopen2(file, name, H5P_DEFAULT), "open");
      values[k].resize(200);
      H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values[k].data());
    }
    EXPECT_EQ(values[0], values[1]) << name;
  }
}

TEST_F(ResumedTrajectory, SparesTheCheckpointItGoesOnFrom) {
  {
    auto writer = TrajectoryWriter::create(path, scene, {"0.1.0", "abc"});
    writer->accept(syntheticFrame(scene, 0));
    writer->keep(filled(100, 1));
    writer->keep(filled(100, 2));
  }
  goOn(1, 2, [](TrajectoryWriter& writer) { writer.keep(filled(100, 3)); });
  const auto found = TrajectoryReader::open(path)->checkpoints();
  EXPECT_EQ(first(found[0], 100), filled(100, 1));
  EXPECT_EQ(first(found[1], 100), filled(100, 3));
}

TEST_F(ResumedTrajectory, TakesOverTheNewDuration) {
  record(path, scene, 5);
  scene.time.duration = 12345.625;
  goOn(5, 6);
  EXPECT_EQ(TrajectoryReader::open(path)->scene().time.duration, 12345.625);
}

TEST_F(ResumedTrajectory, OtherExtentsAreRefused) {
  record(path, scene, 5);
  const auto other = TrajectoryWriter::resume(path, syntheticScene(true, true, 61), 5, 0);
  ASSERT_FALSE(other);
  EXPECT_EQ(other.problems.front().trouble, Trouble::file);
}

TEST_F(ResumedTrajectory, OneThatIsBeingWrittenIsRefused) {
  auto writer = TrajectoryWriter::create(path, scene, {"0.1.0", "abc"});
  ASSERT_TRUE(writer);
  writer->accept(syntheticFrame(scene, 0));
  const auto second = TrajectoryWriter::resume(path, scene, 1, 0);
  ASSERT_FALSE(second);
  EXPECT_NE(second.problems.front().message.find("another program is writing it"), std::string::npos)
      << second.problems.front().message;
}

TEST_F(ResumedTrajectory, DeletedWhileItIsWrittenIsAFailure) {
  auto writer = TrajectoryWriter::create(path, scene, {"0.1.0", "abc"});
  ASSERT_TRUE(writer);
  writer->accept(syntheticFrame(scene, 0));
  std::filesystem::remove(path);
  writer->accept(syntheticFrame(scene, 1));
  ASSERT_TRUE(writer->failure());
  EXPECT_NE(writer->failure()->message.find("has been deleted"), std::string::npos);
}

}  // namespace
}  // namespace bedmix::test
