// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "render/history.h"
#include "render/image.h"
#include "render/style.h"

#include <span>
#include <string>
#include <vector>

namespace bedmix {

/// For each of the `wanted` times the index of the last frame at or before it, of frames at `times`
/// (increasing, at least one); s. A time before the first frame, or more than half a frame interval after the
/// last, is outside the run.
Result<std::vector<std::size_t>> framesAt(std::span<const double> times, std::span<const double> wanted);

/// Times of a sheet that shows a run of this length, s: the paper's 0, 0.5, 1, 2, 3, ... as far as the run
/// goes, at most nine; evenly spaced ones for a run shorter than a second.
std::vector<double> defaultSheetTimes(double duration);

inline constexpr Layers sheetLayers{Layer::particles, Layer::walls};

/// A run's panels in a sheet.
struct SheetRun {
  const Scene* scene = nullptr;
  std::vector<FramePtr> frames;
  std::string title;                    // over its panels; none: no room is left for one
  std::vector<History> histories = {};  // of each frame, where the style needs one
};

/// Contact sheet like Tian et al. (2007), Figs 4 and 8: a row a run, its frames side by side, up to nine in a
/// row, each under its time; one camera for all, cropped to what a run's particles reach; one scale bar; a
/// legend where more than particles, sampling cells and walls is shown; white ground. Drawn for a print 190
/// mm wide at 300 dpi: write it with PngOptions::dpi = sheetDpi. There is no place for the HUD in it.
Result<Image> drawSheet(std::span<const SheetRun> runs, const Style& style = sheetLayers);
inline constexpr double sheetDpi = 300.0;

}  // namespace bedmix
