// SPDX-License-Identifier: MIT
#pragma once

#include "engine/coupling/coupling_grid.h"
#include "engine/coupling/point_box.h"

#include <span>

namespace bedmix {

/// Adds the coupled shares of particles to the cells under them.
void depositVolume(const CouplingGrid& grid, std::span<const Vec2> position, BlockSum<double>& sum);

}  // namespace bedmix
