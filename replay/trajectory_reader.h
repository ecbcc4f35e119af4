// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "replay/provenance.h"
#include "replay/run_event.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace bedmix {

enum class Reading;

/// The frames of a trajectory file, the same to the bit as those that were written. Memory does not grow with
/// the length of the run. HDF5 works in a process of the reader's own, so that damage on which it fails is a
/// Diagnostic like any other.
class TrajectoryReader final : public FrameSource {
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

  /// The scene as it was run, every default resolved.
  const Scene& scene() const;
  /// What began to record it; empty where that cannot be read.
  const Provenance& provenance() const;
  /// What happened to the run, in the order it did; empty where nothing did or that cannot be read.
  const std::vector<RunEvent>& events() const;
  /// Times of the frames, s, strictly increasing. As many as there are frames, at least one.
  const std::vector<double>& times() const;

  /// How many frames the file says that it holds; no fewer than there are.
  std::size_t recorded() const;

  /// Frame `index`, below times().size(). Fails where the file is damaged there or holds what is no number.
  Result<FramePtr> frame(std::size_t index);

  /// What is there of checkpoints, whole or not, by the place each stands in; empty where there is none or it
  /// cannot be read.
  std::vector<std::vector<std::byte>> checkpoints();

  /// The frames in order. Null after the last, and where one cannot be read: then failure() says why.
  FramePtr next() override;
  const std::optional<Diagnostic>& failure() const;

 private:
  struct State;
  explicit TrajectoryReader(std::unique_ptr<State> state);
  static Result<TrajectoryReader> open(const std::filesystem::path& path, Reading reading);

  std::unique_ptr<State> state_;
};

}  // namespace bedmix
