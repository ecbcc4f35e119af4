// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/contradiction.h"

namespace bedmix {

/// Of contradictions(scene), those of sides that are periodic.
std::vector<Contradiction> sidesContradictions(const Scene& scene);

}  // namespace bedmix
