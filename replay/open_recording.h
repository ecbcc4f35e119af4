// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/foreign_frames.h"

#include <filesystem>
#include <memory>

namespace bedmix {

/// What a recording is, by its content.
enum class RecordingKind { run, h5md, lammps, vtk };

struct OpenedRecording {
  RecordingKind kind;
  std::unique_ptr<RecordedFrames> frames;
};

/// Opens a run of bedmix, by its folder or its trajectory.h5, or what another program has written, for which
/// the options are: a file or, where it writes a file a frame, their folder or a name with * in it. Fails on
/// what is neither, not there, or of several kinds.
Result<OpenedRecording> openRecording(const std::filesystem::path& path, const ForeignOptions& options);

}  // namespace bedmix
