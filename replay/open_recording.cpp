// SPDX-License-Identifier: MIT
#include "replay/open_recording.h"

#include "replay/child_process.h"
#include "replay/contained_hdf5.h"
#include "replay/file_trouble.h"
#include "replay/foreign/h5md_source.h"
#include "replay/hdf5_input.h"
#include "replay/trajectory_layout.h"
#include "replay/trajectory_reader.h"

#include <fstream>
#include <string_view>
#include <system_error>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

using namespace std::string_view_literals;

std::string beginningOf(const fs::path& file) {
  std::string bytes(16, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

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

Result<Recording> asRecording(RecordingKind kind, Result<std::unique_ptr<ForeignSource>> source,
                              const fs::path& path, const ForeignOptions& options) {
  if (!source) return std::move(source.problems);
  Result<ForeignFrames> frames = ForeignFrames::make(std::move(*source), path, options);
  if (!frames) return std::move(frames.problems);
  return Recording{kind, std::make_unique<ForeignFrames>(std::move(*frames))};
}

}  // namespace

Result<RecordingKind> kindOfRecording(const fs::path& path) {
  std::error_code error;
  if (fs::exists(path / layout::fileName, error)) return RecordingKind::run;
  if (!fs::exists(path, error))
    return fileTrouble(path,
                       "does not exist; name the folder of a run, its trajectory.h5 or a file of another "
                       "program");
  if (fs::is_directory(path, error))
    return fileTrouble(path, "holds no trajectory.h5; name the folder of a run");
  if (!fs::is_regular_file(path, error)) return fileTrouble(path, "is no file; name a trajectory.h5");
  if (fs::file_size(path, error) == 0) return fileTrouble(path, "is empty");
  if (!beginningOf(path).starts_with("\x89HDF\r\n\x1a\n"sv))
    return fileTrouble(
        path,
        "is no HDF5 file; name a trajectory.h5, the folder of a run or an H5MD file of another "
        "program");
  try {
    return isForeign(path) ? RecordingKind::h5md : RecordingKind::run;
  } catch (const std::system_error& e) {
    return fileTrouble(path, e.what());
  }
}

Result<Recording> openRecording(const fs::path& path, const ForeignOptions& options) {
  const Result<RecordingKind> kind = kindOfRecording(path);
  if (!kind) return kind.problems;
  if (*kind == RecordingKind::h5md)
    return asRecording(*kind, H5mdSource::open(path, options.group), path, options);
  Result<TrajectoryReader> run = TrajectoryReader::open(path);
  if (!run) return std::move(run.problems);
  return Recording{*kind, std::make_unique<TrajectoryReader>(std::move(*run))};
}

}  // namespace bedmix
