// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"

namespace bedmix {

/// Finds which cells the scene's obstacles block, see makeGasGrid(), and sets openCell.
void blockCells(const Scene& scene, GasGrid& grid);

}  // namespace bedmix
