// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "render/style.h"

#include <vector>

namespace bedmix {

/// What of `style` the scene cannot show: see contradictions(scene, pictures).
std::vector<Diagnostic> missingFor(const Scene& scene, const Style& style);
/// The same of a frame: gas fields that are not there or do not fit the scene's grid, no angular
/// velocities.
std::vector<Diagnostic> missingFor(const Scene& scene, const Frame& frame, const Style& style);

}  // namespace bedmix
