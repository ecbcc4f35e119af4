// SPDX-License-Identifier: MIT
#pragma once

#include "engine/coupling/coupling_grid.h"
#include "engine/coupling/point_box.h"

#include <span>

namespace bedmix {

/// Adds the coupled shares of particles, in volumes of the grid's, to the cells under them. `radii` (m) are
/// null where all are alike.
void depositVolume(const CouplingGrid& grid, std::span<const Vec2> position, const double* radii,
                   BlockSum<double>& sum);

}  // namespace bedmix
