// SPDX-License-Identifier: MIT
#pragma once

#include "app/console.h"
#include "render/painter.h"
#include "replay/trajectory_reader.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bedmix {

/// What `bedmix render` is to draw of a run, checked as far as the command line goes.
struct RenderJob {
  TrajectoryReader& reader;
  std::string output;
  std::vector<std::size_t> selected;  // frames, in order; at least one
  PaintOptions paint;
  const Console& console;
};

enum class Ending { complete, stopped };

/// Hands on the selected frames, until one is trouble or a signal stops it.
Result<Ending> forFrames(const RenderJob& job, const std::function<Result<Done>(const Frame&)>& use);

/// A film of `fps` pictures a second, in each of which `speed` simulated seconds go by. Nothing is left of
/// one that is stopped.
ExitCode renderFilm(const RenderJob& job, double fps, double speed);

/// A folder of PNGs, one a frame. Those that are there already, of the same rendering, are kept; those of
/// another are an error, or removed with `force`.
ExitCode renderFolder(const RenderJob& job, bool force);

/// One PNG, of the frame shown at `time`, s; the last one without.
ExitCode renderPicture(const RenderJob& job, std::optional<double> time);

}  // namespace bedmix
