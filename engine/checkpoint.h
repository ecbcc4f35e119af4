// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/scene.h"
#include "engine/simulation.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// A run as bytes that can be kept anywhere: what it is of, the state of its simulation, and a checksum, so
// that whatever comes back damaged or foreign is refused. The layout stands in checkpoint.cpp.

namespace bedmix {

/// What goes on with a run.
struct Resumed {
  Simulation simulation;
  double wallSeconds;  // that the run has taken so far
};

std::vector<std::byte> writeCheckpoint(const Simulation& simulation, const Scene& scene, double wallSeconds);

/// When a checkpoint was taken.
struct CheckpointMark {
  std::int64_t step = 0;
  Refinement refinement;  // of the scene whose steps these are
};
/// None where the bytes are no whole checkpoint. More may follow it.
std::optional<CheckpointMark> checkpointMark(std::span<const std::byte> bytes);

/// The run as it was, which goes on as if it had never stopped. Fails on bytes that are damaged, of another
/// version of the program, or of another scene; one that differs in time.duration alone is the same, and one
/// that is refined further goes on with the shorter steps.
Result<Resumed> readCheckpoint(std::span<const std::byte> bytes, const Scene& scene, int threads);

}  // namespace bedmix
