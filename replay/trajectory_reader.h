// SPDX-License-Identifier: MIT
#pragma once

#include "replay/recorded_frames.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

namespace bedmix {

enum class Reading;

/// The frames of a trajectory file, the same to the bit as those that were written. Memory does not grow with
/// the length of the run. HDF5 works in a process of the reader's own, so that damage on which it fails is a
/// Diagnostic like any other.
class TrajectoryReader final : public RecordedFrames {
 public:
  /// `path` is a trajectory.h5 or the run folder it lies in. Fails on a file that is missing, foreign,
  /// truncated, of another version, inconsistent, or without a frame. A last frame that a killed run left
  /// unfinished is not counted.
  static Result<TrajectoryReader> open(const std::filesystem::path& path);
  /// What is left of a damaged or cut-off file: its first frames, up to one whose step or time is lost or
  /// makes no sense. Fails where nothing of use is. Frames can fail as those of a whole file can.
  static Result<TrajectoryReader> openRemains(const std::filesystem::path& path);
  ~TrajectoryReader() override;
  TrajectoryReader(TrajectoryReader&&) noexcept;
  TrajectoryReader& operator=(TrajectoryReader&&) noexcept;

  const Scene& scene() const override;
  const Provenance& provenance() const override;
  const std::vector<RunEvent>& events() const override;
  const std::vector<double>& times() const override;
  Result<FramePtr> frame(std::size_t index) override;

  /// How many frames the file says that it holds; no fewer than there are.
  std::size_t recorded() const;

  /// What is there of checkpoints, whole or not, by the place each stands in; empty where there is none or it
  /// cannot be read.
  std::vector<std::vector<std::byte>> checkpoints();

 private:
  struct State;
  explicit TrajectoryReader(std::unique_ptr<State> state);
  static Result<TrajectoryReader> open(const std::filesystem::path& path, Reading reading);

  std::unique_ptr<State> state_;
};

}  // namespace bedmix
