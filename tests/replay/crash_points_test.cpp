// SPDX-License-Identifier: MIT
#include "replay/trajectory_writer.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <unistd.h>

// Where crash_test.cpp kills by chance, this goes through every moment there is: between any two writes, and
// inside each that crosses the border of a page, the only places where the system tears one apart. The linker
// hands the driver's calls to the functions below (--wrap).

namespace bedmix::test {
namespace {

constexpr std::size_t page = 4096;

/// A write, or, without bytes, the file made as long as `at`.
struct Change {
  std::size_t at;
  std::string bytes;
};
std::vector<Change>* changes = nullptr;

/// The change in the pieces that a kill can leave behind.
std::vector<Change> pieces(const Change& change) {
  std::vector<Change> list;
  for (std::size_t done = 0; done < change.bytes.size();) {
    const std::size_t at = change.at + done, size = std::min(page - at % page, change.bytes.size() - done);
    list.push_back({at, change.bytes.substr(done, size)});
    done += size;
  }
  return list.empty() ? std::vector{change} : list;
}

void apply(const Change& change, const std::filesystem::path& path) {
  const std::size_t end = change.at + change.bytes.size();
  if (std::filesystem::file_size(path) < end) std::filesystem::resize_file(path, end);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(change.at));
  file << change.bytes;
}

}  // namespace
}  // namespace bedmix::test

extern "C" {
ssize_t __real_pwrite(int file, const void* bytes, size_t size, off_t at);
int __real_ftruncate(int file, off_t size);

ssize_t __wrap_pwrite(int file, const void* bytes, size_t size, off_t at) {
  using namespace bedmix::test;
  if (changes) changes->push_back({static_cast<std::size_t>(at), {static_cast<const char*>(bytes), size}});
  return __real_pwrite(file, bytes, size, at);
}
int __wrap_ftruncate(int file, off_t size) {
  using namespace bedmix::test;
  if (changes) changes->push_back({static_cast<std::size_t>(size), ""});
  return __real_ftruncate(file, size);
}
}

namespace bedmix::test {
namespace {

TEST(CrashPoints, AfterAnyPieceOfAnyWriteAllFramesAreThere) {
  const Scene scene = syntheticScene(true, true, 3);
  const TemporaryFolder folder;
  constexpr int frames = 130;
  std::vector<Change> log;
  std::vector<std::size_t> logged;  // changes until each frame was reported
  {
    changes = &log;
    auto writer = TrajectoryWriter::create(folder / "trajectory.h5", scene, {"0.1.0", "abc"});
    ASSERT_TRUE(writer);
    for (int i = 0; i < frames; ++i) {
      writer->accept(syntheticFrame(scene, i));
      logged.push_back(log.size());
    }
    ASSERT_FALSE(writer->failure());
    changes = nullptr;
  }

  const auto left = folder / "left.h5";
  writeText(left, "");
  std::size_t done = 0, moments = 0;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    // Nodes of the trees split with row 64 and every 57 later, lists of numbers get a new chunk with row 128.
    const bool isTelling = frame > 0 && (frame % 8 < 2 || (frame % 57 > 5 && frame % 57 < 9));
    for (; done < logged[frame]; ++done) {
      for (const Change& piece : pieces(log[done])) {
        apply(piece, left);
        if (!isTelling) continue;
        ++moments;
        const Playback played = playBack(left, scene);
        ASSERT_GE(played.frames, frame) << "change " << done << ": " << played.message;
        ASSERT_LE(played.frames, frame + 1);
      }
    }
  }
  EXPECT_GT(moments, 500u);
}

}  // namespace
}  // namespace bedmix::test
