// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "replay/child_process.h"
#include "replay/frame_pool.h"
#include "replay/read_ahead.h"
#include "replay/shared_memory.h"
#include "replay/trajectory_input.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace bedmix {

/// What a trajectory holds beside its frames and checkpoints.
struct RunPreamble {
  Scene scene;
  RunConstants constants;
};

/// Reads a trajectory in a process of its own: HDF5 1.10 crashes on damaged files, or follows their lists
/// without end. While the frame it has handed over is used, it reads the one that will be asked for if the
/// steps from frame to frame stay as they are. Calls throw ChannelClosed when the process ends; it ends when
/// it computes for longer than the size of the file explains.
class ReaderProcess {
 public:
  ReaderProcess(std::filesystem::path file, Reading reading);

  /// To be called once, and first.
  Result<RunPreamble> open();
  Result<FramePtr> frame(const RunPreamble& run, std::size_t index);
  /// What is there of a checkpoint; empty where that cannot be read.
  std::vector<std::byte> checkpoint(std::size_t slot);
  /// Why it has ended.
  std::string end() { return child_.end(); }

 private:
  std::optional<Diagnostic> trouble();

  std::filesystem::path file_;
  SharedMemory memory_;
  ChildProcess child_;
  std::size_t numbers_ = 0;  // of a frame
  ReadAhead ahead_;
  FramePool pool_;
};

}  // namespace bedmix
