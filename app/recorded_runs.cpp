// SPDX-License-Identifier: MIT
#include "app/recorded_runs.h"

#include "app/png_text.h"
#include "app/run_folder.h"
#include "replay/open_recording.h"

#include <fmt/core.h>

#include <algorithm>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

/// Those that are there more than once are replaced.
std::vector<std::string> madeUnique(const std::vector<std::string>& names,
                                    const std::vector<std::string>& instead) {
  std::vector<std::string> unique = names;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (std::count(names.begin(), names.end(), names[i]) > 1) unique[i] = instead[i];
  return unique;
}

std::string folderName(const fs::path& folder) { return fs::weakly_canonical(folder).filename().string(); }

std::string foreignName(const fs::path& file) {
  return (file.has_filename() ? file : file.parent_path()).stem().string();
}

/// What the style needs of the frames up to the one of this index.
Result<History> historyOf(RecordedFrames& reader, const Style& style, std::size_t index) {
  History history(reader.scene(), style);
  std::vector<std::size_t> seen;
  if (hasClasses(style.color)) seen.push_back(0);
  if (style.layers.has(Layer::trails)) {
    const std::vector<double>& times = reader.times();
    const auto first = std::lower_bound(times.begin(), times.end(), times[index] - style.trailTime);
    for (auto k = static_cast<std::size_t>(first - times.begin()); k < index; ++k) seen.push_back(k);
  }
  seen.push_back(index);
  for (const std::size_t k : seen) {
    const auto frame = reader.frame(k);
    if (!frame) return frame.problems;
    history.observe(**frame);
  }
  return history;
}

/// The frames at `times` as panels of the run.
Result<SheetRun> panelsOf(RecordedRun& run, std::span<const double> times, const Style& style) {
  auto indices = framesAt(run.reader->times(), times);
  if (!indices) {
    for (Diagnostic& d : indices.problems) d.at.file = "--times";
    return indices.problems;
  }
  SheetRun panels{&run.scene(), {}, {}, {}};
  for (const std::size_t index : *indices) {
    auto frame = run.reader->frame(index);
    if (!frame) return frame.problems;
    panels.frames.push_back(*frame);
    if (!hasClasses(style.color) && !style.layers.has(Layer::trails)) continue;
    auto history = historyOf(*run.reader, style, index);
    if (!history) return history.problems;
    panels.histories.push_back(std::move(*history));
  }
  return panels;
}

}  // namespace

std::vector<std::string> runNames(std::span<const std::string> runs) {
  std::vector<std::string> names, paths;
  for (const std::string& run : runs) {
    const fs::path folder = runFolderOf(run);
    names.push_back(folderName(folder));
    paths.push_back(folder.string());
  }
  return madeUnique(names, paths);
}

Result<std::vector<RecordedRun>> openRuns(std::span<const std::string> runs,
                                          const RecordingOptions& options) {
  const Result<ForeignOptions> foreign = foreignOptions(options);
  if (!foreign) return foreign.problems;
  std::vector<RecordedRun> opened;
  std::vector<Diagnostic> problems;
  for (const std::string& run : runs) {
    auto recording = openRecording(run, *foreign);
    if (recording) {
      const bool isForeign = recording->kind != RecordingKind::run;
      const fs::path folder = isForeign ? foreignFolderOf(run) : runFolderOf(run);
      opened.push_back({isForeign ? foreignName(run) : folderName(folder), folder, isForeign,
                        std::move(recording->frames)});
    } else {
      problems.insert(problems.end(), recording.problems.begin(), recording.problems.end());
    }
  }
  if (!problems.empty()) return problems;
  std::vector<std::string> names, paths;
  for (std::size_t i = 0; i < opened.size(); ++i) {
    names.push_back(opened[i].name);
    paths.push_back(opened[i].isForeign ? runs[i] : opened[i].folder.string());
  }
  names = madeUnique(names, paths);
  for (std::size_t i = 0; i < opened.size(); ++i) opened[i].name = names[i];
  return opened;
}

std::vector<std::string> runTitles(std::span<const RecordedRun> runs) {
  std::vector<std::string> titles, named;
  for (const RecordedRun& run : runs) {
    titles.push_back(run.scene().title.empty() ? run.scene().name : run.scene().title);
    named.push_back(fmt::format("{} [{}]", titles.back(), run.name));
  }
  return madeUnique(titles, named);
}

Result<Image> sheetOf(std::span<RecordedRun> runs, std::vector<double> times, const Style& style) {
  if (times.empty()) {
    double begin = runs.front().begin(), end = runs.front().end();
    for (const RecordedRun& run : runs) {
      begin = std::max(begin, run.begin());
      end = std::min(end, run.end());
    }
    times = defaultSheetTimes(end);
    for (double& time : times) time = std::max(time, begin);
    times.erase(std::unique(times.begin(), times.end()), times.end());
  }

  std::vector<SheetRun> rows;
  std::vector<Diagnostic> problems;
  const std::vector<std::string> titles = runTitles(runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    auto panels = panelsOf(runs[i], times, style);
    if (!panels) {
      problems.insert(problems.end(), panels.problems.begin(), panels.problems.end());
      continue;
    }
    SheetRun& row = rows.emplace_back(std::move(*panels));
    if (runs.size() > 1)
      row.title = i < 26 ? fmt::format("({:c}) {}", static_cast<char>('a' + i), titles[i]) : titles[i];
  }
  if (!problems.empty()) return problems;
  return drawSheet(rows, style);
}

PngText pngText(std::span<const RecordedRun> runs) {
  PngText text = pngText(runs.front().scene());
  for (const RecordedRun& run : runs.subspan(1)) {
    const PngText more = pngText(run.scene());
    for (std::size_t i = 0; i < more.size(); ++i)
      if (text[i].second != more[i].second) text[i].second += "; " + more[i].second;
  }
  return text;
}

PngOptions sheetPng(std::span<const RecordedRun> runs) {
  return {.small = true, .text = pngText(runs), .dpi = sheetDpi};
}

}  // namespace bedmix
