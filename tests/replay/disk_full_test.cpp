// SPDX-License-Identifier: MIT
#include "engine/core/rng.h"
#include "replay/export/export_format.h"
#include "replay/series_log.h"
#include "replay/trajectory_writer.h"
#include "tests/replay/synthetic.h"

#include <gtest/gtest.h>

#include <csignal>
#include <functional>
#include <numeric>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bedmix::test {
namespace {

/// Runs `body` in a process none of whose files may grow beyond `bytes`, as on a disk that is full then.
/// Returns what it returns, below 256.
int withFullDisk(rlim_t bytes, const std::function<int()>& body) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
    _exit(body());
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

/// Feeds frames until the sink fails. How many it took before, or 255 where it does not fail as it should.
int framesUntilFailure(FileSink& sink, const Scene& scene) {
  int taken = 0;
  for (; taken < 250 && !sink.failure(); ++taken) sink.accept(syntheticFrame(scene, taken));
  const bool isClear = sink.failure() && sink.failure()->trouble == Trouble::file &&
                       sink.failure()->message.find("File too large") != std::string::npos;
  const std::string first = isClear ? sink.failure()->message : "";
  sink.accept(syntheticFrame(scene, taken));
  return isClear && sink.failure()->message == first ? taken - 1 : 255;
}

TEST(DiskFull, TrajectoryKeepsAllFramesBeforeIt) {
  const Scene scene = syntheticScene(true, true);
  const TemporaryFolder folder;
  Rng rng(11);
  int withFrames = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto path = folder / (std::to_string(trial) + ".h5");
    const auto bytes = static_cast<rlim_t>(rng.uniform(100.0, 300e3));
    const int taken = withFullDisk(bytes, [&] {
      auto writer = TrajectoryWriter::create(path, scene, {"0.1.0", "abc"});
      return writer ? framesUntilFailure(*writer, scene) : 0;
    });
    ASSERT_NE(taken, 255) << bytes << " bytes";
    const Playback left = playBack(path, scene);
    EXPECT_EQ(left.frames, static_cast<std::size_t>(taken)) << bytes << " bytes: " << left.message;
    withFrames += taken > 0;
  }
  EXPECT_GT(withFrames, 30);
}

TEST(DiskFull, SeriesStayWholeUpToTheirLastLine) {
  const Scene scene = syntheticScene(true, true);
  const TemporaryFolder folder;
  for (const rlim_t bytes : {100u, 400u, 1234u, 4096u}) {
    const int taken = withFullDisk(bytes, [&] {
      auto log = MixingLog::create(folder / "mixing.csv", samplingGrid(scene));
      return log ? framesUntilFailure(*log, scene) : 254;
    });
    ASSERT_LT(taken, 250) << bytes << " bytes";
    const auto table = readCsv(folder / "mixing.csv");
    ASSERT_TRUE(table);
    EXPECT_EQ(table->rows(), static_cast<std::size_t>(taken));
  }
}

TEST(DiskFull, ExportsAreWholeUpToTheirLastFrame) {
  const Scene scene = syntheticScene(false, true);
  std::vector<std::size_t> all(250);
  std::iota(all.begin(), all.end(), 0);
  const auto open = [&](const ExportFormat& format, const TemporaryFolder& folder) {
    return format.open({scene, "trajectory.h5", all.size(), all, folder.path()});
  };
  for (const ExportFormat& format : exportFormats())
    for (const rlim_t bytes : {6000u, 12345u}) {
      const TemporaryFolder full, roomy;
      const int taken = withFullDisk(bytes, [&] {
        const auto made = open(format, full);
        return made ? framesUntilFailure(**made, scene) : 254;
      });
      ASSERT_LT(taken, 250) << format.name << ", " << bytes << " bytes";
      const auto made = open(format, roomy);
      ASSERT_TRUE(made);
      for (int i = 0; i < taken; ++i) (*made)->accept(syntheticFrame(scene, i));
      const auto file = (*made)->files().front();
      EXPECT_EQ(fileText(full / file.filename().string()), fileText(file)) << format.name << ", " << bytes;
    }
}

}  // namespace
}  // namespace bedmix::test
