// SPDX-License-Identifier: MIT
#pragma once

#include "replay/foreign/foreign_frames.h"

#include <filesystem>
#include <memory>

namespace bedmix {

/// What a recording is, by its content.
enum class RecordingKind { run, h5md };

/// Fails on what is none, or not there.
Result<RecordingKind> kindOfRecording(const std::filesystem::path& path);

struct Recording {
  RecordingKind kind;
  std::unique_ptr<RecordedFrames> frames;
};

/// Opens a run of bedmix, by its folder or its trajectory.h5, or a file of another program, for which the
/// options are.
Result<Recording> openRecording(const std::filesystem::path& path, const ForeignOptions& options);

}  // namespace bedmix
