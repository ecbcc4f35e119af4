// SPDX-License-Identifier: MIT
#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <span>
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

/// Bytes that tell whether they are whole: how many, a number, and that number all over.
std::vector<std::byte> numbered(std::uint8_t number, std::size_t size) {
  std::vector<std::byte> bytes(size, static_cast<std::byte>(number));
  std::memcpy(bytes.data(), &size, sizeof size);
  return bytes;
}
int numberOf(const std::vector<std::byte>& bytes) {
  std::size_t size = 0;
  if (bytes.size() <= sizeof size) return -1;
  std::memcpy(&size, bytes.data(), sizeof size);
  if (size <= sizeof size || size > bytes.size()) return -1;
  const std::span body = std::span(bytes).subspan(sizeof size, size - sizeof size);
  const bool isWhole = std::all_of(body.begin(), body.end(), [&](std::byte b) { return b == body[0]; });
  return isWhole ? std::to_integer<int>(body[0]) : -1;
}

/// The first session records `first` frames, of which only `same` come out the same in the second, which goes
/// on after `kept`.
struct ResumedRun {
  const char* name;
  int particles;  // rows shorter or longer than a page
  int first, same, kept, last;
};

RunEvent eventAt(int frame) {
  return {0.5 * frame, "note", std::string(static_cast<std::size_t>(frame), 'x')};
}

/// Whether the events of a file are some of those in their order.
bool areEvents(const std::vector<RunEvent>& events, int kept) {
  std::vector<int> frames;
  for (const RunEvent& event : events) {
    const int frame = static_cast<int>(2.0 * event.time);
    if (event != eventAt(frame)) return false;
    if (!frames.empty() && frame <= frames.back() && frame < kept) return false;
    frames.push_back(frame);
  }
  return true;
}

/// How many of the first frames of a file, all of which can be read, are as they must be.
std::size_t framesThere(const std::filesystem::path& path, const Scene& scene) {
  auto reader = TrajectoryReader::open(path);
  EXPECT_TRUE(reader) << toString(reader.problems.front());
  std::size_t frames = 0, right = 0;
  for (FramePtr frame; reader && (frame = reader->next()); ++frames)
    if (right == frames && sameBits(*frame, syntheticFrame(scene, static_cast<int>(frames)))) ++right;
  EXPECT_TRUE(reader && frames == reader->times().size());
  return right;
}

class ResumedCrashPoints : public ::testing::TestWithParam<ResumedRun> {};

/// A run that was resumed, with checkpoints of lengths that change: at any moment all frames that count are
/// there, and one of the last two checkpoints is whole, and it can be resumed again.
TEST_P(ResumedCrashPoints, AfterAnyPieceOfAnyWriteTheRunCanBeResumed) {
  const auto& [name, particles, first, same, kept, last] = GetParam();
  const Scene scene = syntheticScene(true, true, particles);
  const TemporaryFolder folder;
  std::vector<Change> log;
  const auto write = [&](TrajectoryWriter& writer, int frame) {
    writer.accept(syntheticFrame(scene, frame));
    if (frame % 4 == 1) writer.note(eventAt(frame));
    if (frame % 2 == 1) writer.keep(numbered(static_cast<std::uint8_t>(frame), 6000 + frame * 3001 % 9000));
  };
  std::size_t resumedAt = 0;
  std::vector<std::size_t> logged(static_cast<std::size_t>(last));  // changes until each frame was reported
  {
    changes = &log;
    auto writer = TrajectoryWriter::create(folder / "trajectory.h5", scene, {"0.1.0", "abc"});
    ASSERT_TRUE(writer);
    for (int i = 0; i < same; ++i) write(*writer, i);
    for (int i = same; i < first; ++i) {
      Frame other = syntheticFrame(scene, i);
      other.velocity[1].x = 7.0f;
      writer->accept(other);
    }
    ASSERT_FALSE(writer->failure());
  }
  resumedAt = log.size();
  {
    auto writer = TrajectoryWriter::resume(folder / "trajectory.h5", scene, kept, (kept / 2 - 1) % 2);
    ASSERT_TRUE(writer) << writer.problems.front().message;
    for (int i = kept; i < last; ++i) {
      write(*writer, i);
      logged[static_cast<std::size_t>(i)] = log.size();
    }
    ASSERT_FALSE(writer->failure());
    changes = nullptr;
  }

  const auto left = folder / "left.h5", again = folder / "again.h5";
  writeText(left, "");
  for (std::size_t done = 0; done < resumedAt; ++done) apply(log[done], left);
  int reported = kept, moments = 0;
  for (std::size_t done = resumedAt; done < log.size(); ++done) {
    while (reported < last && done >= logged[static_cast<std::size_t>(reported)]) ++reported;
    for (const Change& piece : pieces(log[done])) {
      apply(piece, left);
      const std::size_t frames = framesThere(left, scene);
      ASSERT_GE(frames, static_cast<std::size_t>(std::max(same, reported))) << "change " << done;
      ASSERT_LE(frames, static_cast<std::size_t>(std::max(same, reported) + 1)) << "change " << done;
      auto reader = TrajectoryReader::open(left);
      ASSERT_TRUE(areEvents(reader->events(), kept)) << "change " << done;
      std::vector<int> numbers;
      for (const auto& bytes : reader->checkpoints()) numbers.push_back(numberOf(bytes));
      ASSERT_GE(*std::max_element(numbers.begin(), numbers.end()), kept - 1) << "change " << done;

      if (++moments % 3 != 0) continue;
      std::filesystem::copy_file(left, again, std::filesystem::copy_options::overwrite_existing);
      auto writer = TrajectoryWriter::resume(again, scene, kept, 0);
      ASSERT_TRUE(writer) << writer.problems.front().message;
      for (int i = kept; i < kept + 3; ++i) write(*writer, i);
      ASSERT_FALSE(writer->failure()) << toString(*writer->failure());
      ASSERT_GE(framesThere(again, scene), static_cast<std::size_t>(kept + 3)) << "change " << done;
    }
  }
  EXPECT_GT(moments, 100);
}

INSTANTIATE_TEST_SUITE_P(Runs, ResumedCrashPoints,
                         ::testing::Values(ResumedRun{"ShortRows", 3, 70, 66, 64, 74},
                                           ResumedRun{"LongRows", 600, 13, 9, 8, 15}),
                         [](const auto& run) { return std::string(run.param.name); });

}  // namespace
}  // namespace bedmix::test
