// SPDX-License-Identifier: MIT
#include "replay/recover.h"

#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace fs = std::filesystem;

namespace bedmix::test {
namespace {

constexpr int frames = 150;

class Recover : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const TemporaryFolder folder;
    record(folder / "trajectory.h5", scene(), frames);
    {
      auto writer = TrajectoryWriter::resume(folder / "trajectory.h5", scene(), frames, 1);
      ASSERT_TRUE(writer);
      writer->keep(std::vector<std::byte>(5000, std::byte{7}));
      writer->note({1.25, "resume", "for a test"});
      ASSERT_FALSE(writer->failure());
    }
    whole_ = fileText(folder / "trajectory.h5");
    ends_ = frameEnds(folder / "trajectory.h5");
  }
  static Scene scene() { return syntheticScene(true, true); }

  /// How long the file must be to hold all numbers of each frame, as HDF5 tells it of the whole file.
  static std::vector<std::size_t> frameEnds(const fs::path& path) {
    std::vector<std::size_t> ends(frames, 0);
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    for (const char* series : {"particles/all/position/value", "particles/all/velocity/value",
                               "particles/all/angular_velocity/value", "bedmix/gas/voidage/value",
                               "bedmix/gas/pressure/value", "bedmix/gas/gas_velocity/value"}) {
      const hid_t dataset = H5Dopen2(file, series, H5P_DEFAULT);
      for (hsize_t i = 0; i < frames; ++i) {
        const hsize_t at[]{i, 0, 0, 0};
        unsigned filters = 0;
        haddr_t address = 0;
        hsize_t size = 0;
        EXPECT_GE(H5Dget_chunk_info_by_coord(dataset, at, &filters, &address, &size), 0);
        ends[i] = std::max<std::size_t>(ends[i], address + size);
      }
      H5Dclose(dataset);
    }
    H5Fclose(file);
    return ends;
  }
  /// Frames that lie before a cut with all those before them.
  static std::size_t mostBefore(std::size_t cut) {
    const auto lost = std::find_if(ends_.begin(), ends_.end(), [&](std::size_t end) { return end > cut; });
    return static_cast<std::size_t>(lost - ends_.begin());
  }

  /// Recovers such a file, and expects that it stays as it is and that what is saved is right.
  Result<Recovery> recoverFrom(const std::string& bytes) const {
    writeText(file_, bytes);
    const auto then = fs::last_write_time(file_);
    fs::remove(saved_);
    const auto found = recover(file_, saved_,
                               [](auto checkpoint, const Scene&, std::size_t) {
                                 return std::all_of(checkpoint.begin(), checkpoint.end(),
                                                    [](std::byte b) { return b == std::byte{7}; }) &&
                                        !checkpoint.empty();
                               },
                               {"0.1.0", "def"});
    EXPECT_EQ(fileText(file_), bytes);
    EXPECT_EQ(fs::last_write_time(file_), then);
    EXPECT_EQ(fs::exists(saved_), found && found->damage);
    EXPECT_FALSE(fs::exists(saved_.string() + ".part"));
    if (found && found->damage) {
      EXPECT_EQ(playBack(saved_, scene()).frames, found->frames);
    }
    return found;
  }

  static inline std::string whole_;
  static inline std::vector<std::size_t> ends_;
  TemporaryFolder folder_;
  fs::path file_ = folder_ / "trajectory.h5", saved_ = folder_ / "saved.h5";
};

TEST_F(Recover, ASoundFileIsLeftAlone) {
  const auto found = recoverFrom(whole_);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->damage);
  EXPECT_EQ(found->frames, static_cast<std::size_t>(frames));
  EXPECT_EQ(found->checkpoints, 1u);
}

TEST_F(Recover, OfACutFileWhatItsIndexStillFinds) {
  // HDF5's list of chunks has 64 entries a part. When a part is full, it is split, and its last entries go to
  // a new one behind what has been written so far; the first part moves there as a whole. A cut loses parts
  // that lie behind it: the 13 entries that moved, and the frames written while all series were split (here
  // 8, for they are smaller than the parts); and all of the first 64 where it comes before their part has
  // moved.
  constexpr std::size_t part = 64, moved = 13, meanwhile = 8;
  std::size_t before = 0;
  for (int i = 1; i < 15; ++i) {
    const std::size_t cut = whole_.size() * static_cast<std::size_t>(i) / 15;
    const auto found = recoverFrom(whole_.substr(0, cut));
    const std::size_t most = mostBefore(cut), saved = found ? found->frames : 0;
    EXPECT_LE(saved, most) << cut;
    EXPECT_GE(saved, before) << cut;
    if (most > part + meanwhile) {
      EXPECT_GE(saved + moved + meanwhile, most) << cut;
    }
    if (found) {
      EXPECT_EQ(found->recorded, static_cast<std::size_t>(frames));
    }
    before = saved;
  }
  EXPECT_GT(before, static_cast<std::size_t>(frames) * 9 / 10);
}

TEST_F(Recover, OfACutFileOfAShortRunSomeFrames) {
  constexpr int few = 60;
  record(folder_ / "short.h5", scene(), few);
  const std::string bytes = fileText(folder_ / "short.h5");
  for (const int i : {12, 16, 19}) {
    const std::size_t cut = bytes.size() * static_cast<std::size_t>(i) / 20;
    const auto found = recoverFrom(bytes.substr(0, cut));
    ASSERT_TRUE(found) << found.problems.front().message;
    EXPECT_EQ(found->recorded, static_cast<std::size_t>(few));
  }
}

TEST_F(Recover, TheLogAndTheRecoveryInIt) {
  const auto found = recoverFrom(whole_.substr(0, whole_.size() * 19 / 20));
  ASSERT_TRUE(found) << found.problems.front().message;
  const auto reader = TrajectoryReader::open(saved_);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->provenance(), (Provenance{"0.1.0", "abc"}));
  ASSERT_FALSE(reader->events().empty());
  EXPECT_EQ(reader->events().back().kind, "recover");
  EXPECT_EQ(reader->events().back().time, found->until);
}

TEST_F(Recover, FramesBeforeOneThatIsDamaged) {
  const Frame damaged = syntheticFrame(scene(), 72);
  std::string bytes = whole_;
  const std::string row(reinterpret_cast<const char*>(damaged.velocity.data()), 64);
  const std::size_t at = bytes.find(row);
  ASSERT_NE(at, std::string::npos);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(bytes.data() + at, &nan, sizeof nan);
  const auto found = recoverFrom(bytes);
  ASSERT_TRUE(found && found->damage);
  EXPECT_EQ(found->frames, 72u);
  EXPECT_EQ(found->until, syntheticFrame(scene(), 71).time);
  EXPECT_EQ(found->checkpoints, 1u);
  EXPECT_NE(found->damage->message.find("frame 72"), std::string::npos);
}

TEST_F(Recover, AllOfAFileWhoseSuperblockIsDamaged) {
  for (const std::size_t at : {20u, 45u}) {  // flags that HDF5 refuses, and where the file ends
    std::string bytes = whole_;
    bytes[at] = at == 20 ? '\x10' : '\x05';
    const auto found = recoverFrom(bytes);
    ASSERT_TRUE(found) << at << ": " << found.problems.front().message;
    EXPECT_TRUE(found->damage) << at;
    EXPECT_EQ(found->frames, static_cast<std::size_t>(frames)) << at;
  }
}

TEST_F(Recover, NoFrameIsMadeUpWhereAListOfChunksIsLost) {
  // Lists of chunks, at the lowest level: "TREE", kind 1, level 0
  const std::string leaf{"TREE\x01\x00", 6};
  for (std::size_t at = whole_.find(leaf); at != std::string::npos; at = whole_.find(leaf, at + 1)) {
    for (const std::size_t from : {std::size_t{0}, std::size_t{6}}) {
      std::string bytes = whole_;
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at + from), 40, '\0');
      (void)recoverFrom(bytes);
    }
  }
}

TEST_F(Recover, WhatCannotBeSavedLeavesNothing) {
  for (const std::string& bytes : {std::string(), whole_.substr(0, 50), whole_.substr(0, 5000),
                                   std::string(100000, 'x'), whole_.substr(0, 8) + std::string(9000, '\0')}) {
    const auto found = recoverFrom(bytes);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.problems.front().trouble, Trouble::file);
  }
  EXPECT_FALSE(recover(folder_ / "none.h5", saved_, {}, {}));
}

TEST_F(Recover, NothingIsOverwritten) {
  writeText(file_, whole_.substr(0, whole_.size() / 2));
  writeText(saved_, "mine");
  EXPECT_FALSE(recover(file_, saved_, {}, {}));
  EXPECT_EQ(fileText(saved_), "mine");
}

}  // namespace
}  // namespace bedmix::test
