// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/scene.h"
#include "replay/provenance.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>

namespace bedmix {

/// What is left of a trajectory.
struct Recovery {
  std::size_t frames = 0, recorded = 0;  // there, of those that the file says it holds
  double until = 0.0;                    // s, time of the last
  std::size_t checkpoints = 0;           // that a run can go on from
  std::optional<Diagnostic> damage;      // none where the file is sound
};

/// Whether a run of the scene can go on from these bytes when its first `frames` frames are there.
using CheckpointTest =
    std::function<bool(std::span<const std::byte> checkpoint, const Scene& scene, std::size_t frames)>;

/// Writes what is left of a damaged or cut-off trajectory into a new one: its frames up to the first that is
/// damaged, each the same to the bit, the log, with the recovery as its last event, and the checkpoints that
/// pass. Of a sound one nothing is written. `file` is only read, and a run may be writing it. Fails where
/// nothing can be saved or written, and then leaves nothing, and where there is something at `into`.
Result<Recovery> recover(const std::filesystem::path& file, const std::filesystem::path& into,
                         const CheckpointTest& isUsable, const Provenance& by);

}  // namespace bedmix
