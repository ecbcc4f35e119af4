// SPDX-License-Identifier: MIT
#include "replay/open_recording.h"

#include "replay/child_process.h"
#include "replay/contained_hdf5.h"
#include "replay/file_trouble.h"
#include "replay/foreign/h5md_source.h"
#include "replay/foreign/lammps_dump.h"
#include "replay/foreign/vtk_series.h"
#include "replay/hdf5_input.h"
#include "replay/trajectory_layout.h"
#include "replay/trajectory_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <fnmatch.h>
#include <fstream>
#include <string_view>
#include <system_error>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

using namespace std::string_view_literals;

constexpr const char* whatThereIs =
    "name the folder of a run, its trajectory.h5, or another program's H5MD file, LAMMPS dump or VTK points";

/// Whether an H5MD file is of another program. Where HDF5 fails on it, TrajectoryReader says how.
bool isForeign(const fs::path& file) {
  ChildProcess child([&](Channel& parent) {
    bool foreign = false;
    allowWorkOn(file);
    troubleOf([&] {
      const Hdf5Input in(file);
      foreign = in.has("h5md") && !in.has(layout::scene);
    });
    parent.put(foreign);
  });
  try {
    return child.channel().get<bool>();
  } catch (const ChannelClosed&) {
    return false;
  }
}

/// None of what is no recording.
std::optional<RecordingKind> kindOf(const fs::path& file) {
  std::string bytes(16, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (bytes.starts_with("ITEM:") || bytes.starts_with("\x1f\x8b"sv)) return RecordingKind::lammps;
  if (bytes.starts_with("<?xml") || bytes.starts_with("<VTKFile") || bytes.starts_with("# vtk DataFile"))
    return RecordingKind::vtk;
  if (!bytes.starts_with("\x89HDF\r\n\x1a\n"sv)) return std::nullopt;
  return isForeign(file) ? RecordingKind::h5md : RecordingKind::run;
}

/// Files of another program.
struct Series {
  RecordingKind kind;
  std::vector<fs::path> files;
};

/// Those in `folder` whose names fit, in the order of their names.
Result<Series> seriesIn(const fs::path& folder, const std::string& pattern, const fs::path& path) {
  std::error_code error;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.is_regular_file(error) &&
        fnmatch(pattern.c_str(), entry.path().filename().c_str(), FNM_PERIOD) == 0)
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Series series{RecordingKind::run, {}};
  for (const fs::path& file : files) {
    const std::optional<RecordingKind> kind = kindOf(file);
    if (!kind) continue;
    if (!series.files.empty() && kind != series.kind)
      return fileTrouble(
          path,
          fmt::format("holds recordings of several kinds, as {} and {}; name those of one, as "
                      "\"{}/dump.*\"",
                      series.files.back().filename().string(), file.filename().string(), folder.string()));
    series.kind = *kind;
    series.files.push_back(file);
  }
  if (series.files.empty()) return fileTrouble(path, fmt::format("holds no recording; {}", whatThereIs));
  const bool isFileAFrame = series.kind == RecordingKind::lammps || series.kind == RecordingKind::vtk;
  if (!isFileAFrame && series.files.size() > 1)
    return fileTrouble(path, fmt::format("holds {} recordings, the first is {}; name one",
                                         series.files.size(), series.files.front().filename().string()));
  return series;
}

Result<Series> seriesOf(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path / layout::fileName, error)) return Series{RecordingKind::run, {path}};
  if (fs::is_directory(path, error)) return seriesIn(path, "*", path);
  if (!fs::exists(path, error) && path.filename().string().find('*') != std::string::npos)
    return seriesIn(path.has_parent_path() ? path.parent_path() : ".", path.filename(), path);
  if (!fs::exists(path, error)) return fileTrouble(path, fmt::format("does not exist; {}", whatThereIs));
  if (!fs::is_regular_file(path, error)) return fileTrouble(path, fmt::format("is no file; {}", whatThereIs));
  if (fs::file_size(path, error) == 0) return fileTrouble(path, "is empty: nothing was written to it yet");
  if (const auto kind = kindOf(path)) return Series{*kind, {path}};
  return fileTrouble(path, fmt::format("is no recording that bedmix knows; {}", whatThereIs));
}

Result<std::unique_ptr<ForeignSource>> sourceOf(const Series& series, const ForeignOptions& options) {
  if (series.kind == RecordingKind::h5md) return H5mdSource::open(series.files.front(), options.group);
  return series.kind == RecordingKind::vtk ? openVtkSeries(series.files) : openLammpsDump(series.files);
}

}  // namespace

Result<OpenedRecording> openRecording(const fs::path& path, const ForeignOptions& options) {
  try {
    const Result<Series> series = seriesOf(path);
    if (!series) return series.problems;
    if (series->kind == RecordingKind::run) {
      Result<TrajectoryReader> run = TrajectoryReader::open(series->files.front());
      if (!run) return std::move(run.problems);
      return OpenedRecording{series->kind, std::make_unique<TrajectoryReader>(std::move(*run))};
    }
    auto source = sourceOf(*series, options);
    if (!source) return std::move(source.problems);
    Result<ForeignFrames> frames = ForeignFrames::make(std::move(*source), path, options);
    if (!frames) return std::move(frames.problems);
    return OpenedRecording{series->kind, std::make_unique<ForeignFrames>(std::move(*frames))};
  } catch (const std::system_error& e) {
    return fileTrouble(path, e.what());
  }
}

}  // namespace bedmix
