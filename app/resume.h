// SPDX-License-Identifier: MIT
#pragma once

#include "app/console.h"
#include "engine/checkpoint.h"
#include "engine/core/scene.h"
#include "replay/trajectory_reader.h"

#include <cstddef>
#include <optional>

namespace bedmix {

/// Where a run that has ended is gone on with.
struct ResumePoint {
  Resumed start;
  std::size_t frames = 0;  // recorded up to there
  std::size_t slot = 0;    // place of its checkpoint in the trajectory
};

/// The newest sound checkpoint of a recorded run; warns of a damaged one. Fails where there is none, and
/// where `scene` differs from the recorded one in more than its duration, naming the first difference.
Result<ResumePoint> findResumePoint(TrajectoryReader& recorded, const Scene& scene, int threads,
                                    const Console& console);

/// The first setting in which two scenes differ, their durations apart.
std::optional<Diagnostic> sceneDifference(const Scene& recorded, const Scene& asked);

}  // namespace bedmix
