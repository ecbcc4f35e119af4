// SPDX-License-Identifier: MIT
#pragma once

#include "app/console.h"
#include "app/recorded_runs.h"

#include <filesystem>
#include <span>

namespace bedmix {

/// Simulated seconds per second of a film of a run this long, s: 1, 2 or 5 times a power of ten, so that it
/// lasts 8 to 20 s.
double filmSpeed(double duration);

/// Films runs (at least one) for a web page, side by side, with their indices as curves: half the size of a
/// usual film, at filmSpeed(), so that the file stays small whatever the length of the runs. Reads the frames
/// that are shown, no others.
Result<Done> filmForPage(std::span<RecordedRun> runs, const std::filesystem::path& mp4,
                         const Console& console);

}  // namespace bedmix
