// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/period.h"

#include <optional>

namespace bedmix {

/// Neighbours of a disc in its densest packing; Godlieb, Deen & Kuipers (2007) take the twelve of a sphere.
inline constexpr int planeNeighbours = 6;

/// Nearest-neighbour index of Godlieb, Deen & Kuipers (2007): how many of the `neighbours` nearest of each
/// particle are of the other species, over what is expected where so many of the particles are tagged at
/// random, 2 p (1-p) N/(N-1) of them: exactly 1 on average for any positions and any tracer fraction p (as
/// printed, for p = 1/2, twice the fraction). Particles at one distance share the last places, so that no
/// order decides. About O(N). Empty where there is only one species; particles not at finite positions are
/// left out. With periodic sides distances are those of the nearest images.
std::optional<double> neighbourIndex(const Frame& frame, int neighbours = planeNeighbours,
                                     const Period& period = {});

}  // namespace bedmix
