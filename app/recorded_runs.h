// SPDX-License-Identifier: MIT
#pragma once

#include "render/png.h"
#include "render/sheet.h"
#include "replay/trajectory_reader.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

// Runs that figures are made of.

namespace bedmix {

/// Short names of runs, in their order, no two the same: those of their folders, or else what the user wrote.
std::vector<std::string> runNames(std::span<const std::string> runs);

struct RecordedRun {
  std::string name;  // of runNames()
  std::filesystem::path folder;
  TrajectoryReader reader;

  const Scene& scene() const { return reader.scene(); }
  double end() const { return reader.times().back(); }  // s
};

/// Opens runs, each by its folder or trajectory. Fails with what is wrong with any of them.
Result<std::vector<RecordedRun>> openRuns(std::span<const std::string> runs);

/// What tells runs apart in a figure or table: the titles of their scenes, with the run's name where two have
/// the same.
std::vector<std::string> runTitles(std::span<const RecordedRun> runs);

/// The sheet of runs at the same times, read frame by frame; without times at those that suit the shortest.
/// Several runs are lettered and titled. A time that a run does not have is a problem of `--times`.
Result<Image> sheetOf(std::span<RecordedRun> runs, std::vector<double> times, const Style& style);

/// Where a picture of them comes from.
PngText pngText(std::span<const RecordedRun> runs);

/// How a sheet of them is written: at its size in print, with where it comes from.
PngOptions sheetPng(std::span<const RecordedRun> runs);

}  // namespace bedmix
