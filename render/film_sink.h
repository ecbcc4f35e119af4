// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "render/painter.h"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <vector>

namespace bedmix {

struct FilmOptions {
  PaintOptions paint;
  double fps = 50.0;
  double speed = 1.0;                                   // simulated seconds per second of film
  double from = 0.0;                                    // s
  double to = std::numeric_limits<double>::infinity();  // s
};

/// How many pictures a film has whose frames reach from `from` to `to`.
std::int64_t picturesOf(const FilmOptions& options);

/// Films a stream of frames, of one run or of several side by side: at film time n/fps it shows the last
/// frame of each at or before from + n speed/fps, the first where there is none yet. Draws in the caller's
/// thread, and only what is shown; encodes in a thread of its own behind a short queue. Memory does not grow
/// with length.
class FilmSink final : public FrameSink {
 public:
  static Result<FilmSink> create(std::vector<PaintedBed> beds, const std::filesystem::path& path,
                                 const FilmOptions& options = {});
  static Result<FilmSink> create(const Scene& scene, const std::filesystem::path& path,
                                 const FilmOptions& options = {});
  ~FilmSink() override;  // without finish(): no film is left
  FilmSink(FilmSink&&) noexcept;
  FilmSink& operator=(FilmSink&&) noexcept;

  /// Frames in order of time, those of all beds together. After a failure, which finish() reports, it does
  /// nothing.
  void accept(std::size_t bed, const Frame& frame);
  void accept(const Frame& frame) override { accept(0, frame); }
  /// Ends the film with the last frame seen; the first trouble met on the way, or none.
  Result<Done> finish();
  /// Pictures in the film so far.
  std::int64_t pictures() const;
  /// Whether something has failed, which finish() reports.
  bool failed() const;

 private:
  struct State;
  explicit FilmSink(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
