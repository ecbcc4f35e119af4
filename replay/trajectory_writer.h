// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "replay/file_sink.h"
#include "replay/provenance.h"
#include "replay/run_event.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace bedmix {

/// Records frames in an H5MD 1.1 file (de Buyl, Colberg & Höfling 2014, Comput. Phys. Commun. 185:1546), laid
/// out as trajectory_layout.h says. Each frame is flushed, so that whatever kills the program leaves a file
/// that is readable up to the last frame. All HDF5 of a process belongs in one thread.
class TrajectoryWriter final : public FileSink {
 public:
  /// Makes the file anew. Fails where it cannot be made.
  static Result<TrajectoryWriter> create(const std::filesystem::path& path, const Scene& scene,
                                         const Provenance& provenance);
  /// Goes on with the file of a run of that scene, or of one that differs in its duration alone, after the
  /// first `frames` of its frames, of which there must be as many. Later ones stay as long as what is
  /// accepted is the same to the bit, and are all taken out where it is not. `sound` is the checkpoint not to
  /// be replaced by the next. A file on which HDF5 fails is refused and stays as it is: all that will be done
  /// to it is rehearsed in a process of its own.
  static Result<TrajectoryWriter> resume(const std::filesystem::path& path, const Scene& scene,
                                         std::size_t frames, std::size_t sound);
  ~TrajectoryWriter() override;
  TrajectoryWriter(TrajectoryWriter&&) noexcept;
  TrajectoryWriter& operator=(TrajectoryWriter&&) noexcept;

  /// Keeps a checkpoint of the run at the last frame, and the one before this. A failure is kept as that of a
  /// frame is.
  void keep(std::span<const std::byte> checkpoint);
  /// Adds to the run's log, which no cut of frames shortens. A failure is kept likewise.
  void note(const RunEvent& event);
  /// Ends the run with the last frame: those that were there behind it are taken out.
  void finish();

 private:
  struct State;
  explicit TrajectoryWriter(std::unique_ptr<State> state);
  static void rehearseResume(const std::filesystem::path& path, const Scene& scene, std::size_t frames,
                             std::size_t sound);
  std::optional<Diagnostic> write(const Frame& frame) override;
  template <class Action>
  std::optional<Diagnostic> attempt(Action&& action);

  std::unique_ptr<State> state_;
};

/// The library that trajectories are written with, e.g. "HDF5 1.10.8".
std::string hdf5Version();

}  // namespace bedmix
