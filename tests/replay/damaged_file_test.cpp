// SPDX-License-Identifier: MIT
#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <unistd.h>

// Files on which HDF5 1.10.8 crashes or never comes back. See also tests/fuzz/corpus/trajectory.

namespace bedmix::test {
namespace {

template <class T>
T numberAt(const std::string& bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}
template <class T>
void setNumber(std::string& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

class DamagedFile : public testing::Test {
 protected:
  void SetUp() override { record(path_, scene_, 3); }

  void damage(const std::function<void(std::string&)>& change) const {
    std::string bytes = fileText(path_);
    change(bytes);
    writeText(path_, bytes);
  }

  Scene scene_ = syntheticScene(false, false);
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "trajectory.h5";
};

TEST_F(DamagedFile, FreeListOfAGroupWithoutEnd) {
  damage([](std::string& bytes) {
    // "HEAP", version, size; then where the free list begins, and what it is counted from
    constexpr std::uint64_t none = 1;
    int spoiled = 0;
    for (std::size_t at = bytes.find("HEAP"); at != std::string::npos; at = bytes.find("HEAP", at + 1)) {
      const auto head = numberAt<std::uint64_t>(bytes, at + 16),
                 data = numberAt<std::uint64_t>(bytes, at + 24);
      if (head == none) continue;
      setNumber(bytes, data + head, head);  // the first one follows itself
      ++spoiled;
    }
    ASSERT_GT(spoiled, 0);
  });
  const auto reader = TrajectoryReader::open(path_);
  ASSERT_FALSE(reader);
  EXPECT_EQ(reader.problems.front().trouble, Trouble::file);
  EXPECT_NE(toString(reader.problems.front()).find("trajectory.h5: "), std::string::npos);
}

TEST_F(DamagedFile, ChunksWithoutDimensions) {
  damage([](std::string& bytes) {
    // Layout of a list of bytes in chunks: version, kind, dimensions; the index's address; extents of a chunk
    using namespace std::string_view_literals;
    constexpr std::string_view begin = "\x03\x02\x02"sv, chunk = "\x00\x10\x00\x00\x01\x00\x00\x00"sv;
    int spoiled = 0;
    for (std::size_t at = bytes.find(begin); at != std::string::npos; at = bytes.find(begin, at + 1)) {
      const std::size_t extents = at + begin.size() + sizeof(std::uint64_t);
      if (bytes.compare(extents, chunk.size(), chunk) != 0) continue;
      bytes[at + 2] = 0;
      ++spoiled;
    }
    ASSERT_EQ(spoiled, 2);
  });
  auto reader = TrajectoryReader::open(path_);
  ASSERT_TRUE(reader) << toString(reader.problems.front());
  for (const auto& checkpoint : reader->checkpoints()) EXPECT_TRUE(checkpoint.empty());
  EXPECT_EQ(playBack(path_, scene_).frames, 3u);

  const std::string before = fileText(path_);
  const auto writer = TrajectoryWriter::resume(path_, scene_, 2, 0);
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.problems.front().trouble, Trouble::file);
  EXPECT_NE(writer.problems.front().message.find("HDF5 library fails on it"), std::string::npos)
      << writer.problems.front().message;
  EXPECT_EQ(fileText(path_), before);
}

TEST_F(DamagedFile, ChunkOfACheckpointThatIsTooSmallIsNotWrittenTo) {
  {
    auto writer = TrajectoryWriter::resume(path_, scene_, 3, 0);
    ASSERT_TRUE(writer);
    for (int slot = 0; slot < 2; ++slot) writer->keep(std::vector<std::byte>(5000, std::byte{7}));
    ASSERT_FALSE(writer->failure());
  }
  damage([](std::string& bytes) {
    // The index of a list of bytes in chunks: "TREE", kind, level, number of entries; two neighbours; then
    // for each chunk its size first
    using namespace std::string_view_literals;
    constexpr std::string_view begin = "TREE\x01\x00\x02\x00"sv;
    constexpr std::uint32_t whole = 4096, less = 8;
    int spoiled = 0;
    for (std::size_t at = bytes.find(begin); at != std::string::npos; at = bytes.find(begin, at + 1)) {
      const std::size_t size = at + begin.size() + 2 * sizeof(std::uint64_t);
      if (numberAt<std::uint32_t>(bytes, size) != whole) continue;
      setNumber(bytes, size, less);
      ++spoiled;
    }
    ASSERT_GT(spoiled, 0);
  });
  const std::string before = fileText(path_);
  const auto writer = TrajectoryWriter::resume(path_, scene_, 2, 0);
  ASSERT_FALSE(writer);
  EXPECT_NE(writer.problems.front().message.find("it has not as many bytes as it says"), std::string::npos)
      << writer.problems.front().message;
  EXPECT_EQ(fileText(path_), before);
}

TEST_F(DamagedFile, AnEndOfTheProcessThatReadsIsMadeGood) {
  auto reader = TrajectoryReader::open(path_);
  ASSERT_TRUE(reader);
  for (const int index : {0, 1, 2, 0}) {
    std::ifstream children("/proc/self/task/" + std::to_string(getpid()) + "/children");
    pid_t child = 0;
    ASSERT_TRUE(children >> child);
    ASSERT_EQ(kill(child, SIGKILL), 0);
    const auto frame = reader->frame(static_cast<std::size_t>(index));
    ASSERT_TRUE(frame) << toString(frame.problems.front());
    EXPECT_TRUE(sameBits(**frame, syntheticFrame(scene_, index)));
  }
}

TEST_F(DamagedFile, AnyOrderOfFramesIsTheSame) {
  record(path_, scene_, 12);
  auto reader = TrajectoryReader::open(path_);
  ASSERT_TRUE(reader);
  for (const int index : {0, 1, 2, 4, 6, 8, 10, 10, 9, 8, 3, 11, 11, 0, 5}) {
    const auto frame = reader->frame(static_cast<std::size_t>(index));
    ASSERT_TRUE(frame);
    EXPECT_TRUE(sameBits(**frame, syntheticFrame(scene_, index))) << index;
    if (index == 4) reader->checkpoints();
  }
}

}  // namespace
}  // namespace bedmix::test
