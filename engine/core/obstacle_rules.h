// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/contradiction.h"

namespace bedmix {

/// What is wrong with a scene's obstacles and with the motion of its floor.
std::vector<Contradiction> obstacleContradictions(const Scene& scene);

}  // namespace bedmix
