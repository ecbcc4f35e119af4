// SPDX-License-Identifier: MIT
#pragma once

#include "app/accuracy/findings.h"

#include <filesystem>

namespace bedmix {

/// Work-precision diagrams into `folder`: contacts.png (errors of single contacts against their wall time),
/// trajectories.png (distance from a converged reference within the time it can be predicted) and
/// statistics.png (differences of means with their intervals), against wall time. A line a knob; the scene
/// itself, the paper's numerics and the front of what nothing beats are marked.
Result<Done> drawDiagrams(const std::filesystem::path& folder, const Design& design,
                          const Findings& findings);

}  // namespace bedmix
