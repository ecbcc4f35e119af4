// SPDX-License-Identifier: MIT
#pragma once

#include "app/console.h"
#include "app/recorded_runs.h"
#include "render/last_frames.h"
#include "render/painter.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace bedmix {

/// What `bedmix render` is to draw, checked as far as the command line goes.
struct RenderJob {
  std::vector<RecordedRun>& runs;                  // beds side by side
  std::vector<std::vector<std::size_t>> selected;  // frames of each, in order; at least one
  std::string output;
  PaintOptions paint;
  const Console& console;

  std::vector<PaintedBed> beds() const;
};

enum class Ending { complete, stopped };

/// A frame of the bed-th run. One that is not selected comes before those that are, where pictures show what
/// was earlier.
using FrameUse = std::function<Result<Done>(std::size_t bed, const Frame& frame, bool isSelected)>;

/// Hands on frames of all runs in order of time, until one is trouble or a signal stops it. Of one time, the
/// first run's comes last.
Result<Ending> forFrames(const RenderJob& job, const FrameUse& use);

/// A film of `fps` pictures a second, in each of which `speed` simulated seconds go by. Nothing is left of
/// one that is stopped.
ExitCode renderFilm(const RenderJob& job, double fps, double speed);

/// A folder of PNGs, one a selected frame of the first run. Those that are there already, of the same
/// rendering, are kept; those of another are an error, or removed with `force`.
ExitCode renderFolder(const RenderJob& job, bool force);

/// One PNG, of the last frames that are selected.
ExitCode renderPicture(const RenderJob& job);

}  // namespace bedmix
