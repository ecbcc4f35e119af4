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
  std::optional<TrajectoryReader> recorded;  // until its files are written again
  Resumed start;
  Scene scene;             // that it goes on with: that asked for, its steps halved as often as they were
  std::size_t frames = 0;  // recorded up to there
  std::size_t slot = 0;    // place of its checkpoint in the trajectory
};

/// The newest sound checkpoint of a recorded run; warns of a damaged one. Fails where there is none, and
/// where `scene` differs from the recorded one in more than its duration, naming the first difference. With a
/// `refinement` it goes on with these steps instead of those of the checkpoint, which must not be shorter.
Result<ResumePoint> findResumePoint(TrajectoryReader recorded, const Scene& scene, int threads,
                                    const Console& console, std::optional<Refinement> refinement = {});

/// How many frames must be recorded for a run of the scene to go on from a checkpoint.
std::size_t framesUntil(const CheckpointMark& mark, const Scene& scene);

/// The first setting in which two scenes differ, their durations apart.
std::optional<Diagnostic> sceneDifference(const Scene& recorded, const Scene& asked);

}  // namespace bedmix
