// SPDX-License-Identifier: MIT
#pragma once

#include "app/recording_options.h"
#include "render/png.h"
#include "render/sheet.h"
#include "replay/recorded_frames.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

// Runs that figures are made of.

namespace bedmix {

/// Short names of runs, in their order, no two the same: those of their folders, or else what the user wrote.
std::vector<std::string> runNames(std::span<const std::string> runs);

struct RecordedRun {
  std::string name;              // of its folder or, where it is another program's, its file
  std::filesystem::path folder;  // of its series; of another program's FILE: FILE-replay
  bool isForeign;                // another program's
  std::unique_ptr<RecordedFrames> reader;

  const Scene& scene() const { return reader->scene(); }
  double begin() const { return reader->times().front(); }  // s
  double end() const { return reader->times().back(); }     // s
  /// Where `bedmix replay` puts what it derives, unless it is told.
  std::filesystem::path replayFolder() const { return isForeign ? folder : folder / "replay"; }
};

/// Opens runs, each by its folder or trajectory, and files of other programs, which the options are for.
/// Fails with what is wrong with any of them.
Result<std::vector<RecordedRun>> openRuns(std::span<const std::string> runs, const RecordingOptions& options);

/// What tells runs apart in a figure or table: the titles of their scenes, with the run's name where two have
/// the same.
std::vector<std::string> runTitles(std::span<const RecordedRun> runs);

/// The sheet of runs at the same times, read frame by frame; without times at those that suit the shortest
/// and that all have begun by.
/// Several runs are lettered and titled. A time that a run does not have is a problem of `--times`.
Result<Image> sheetOf(std::span<RecordedRun> runs, std::vector<double> times, const Style& style);

/// Where a picture of them comes from.
PngText pngText(std::span<const RecordedRun> runs);

/// How a sheet of them is written: at its size in print, with where it comes from.
PngOptions sheetPng(std::span<const RecordedRun> runs);

}  // namespace bedmix
