// SPDX-License-Identifier: MIT
#pragma once

#include "app/console.h"
#include "replay/trajectory_reader.h"

#include <filesystem>

namespace bedmix {

/// Simulated seconds per second of a film of a run this long, s: 1, 2 or 5 times a power of ten, so that it
/// lasts 8 to 20 s.
double filmSpeed(double duration);

/// Films a run for a web page: half the size of a usual film, at filmSpeed(), so that its file stays small
/// whatever the length of the run. Reads the frames that are shown, no others.
Result<Done> filmForPage(TrajectoryReader& reader, const std::filesystem::path& mp4, const Console& console);

}  // namespace bedmix
