// SPDX-License-Identifier: MIT
#pragma once

#include "render/draw_bed.h"

namespace bedmix {

/// Appends an arrow from each particle's centre, as long as it is fast.
void drawVelocity(DrawList& list, const BedView& view);

/// Appends an arrow through the middle of each sampling cell that holds at least five particles: their mean
/// velocity.
void drawFlow(DrawList& list, const BedView& view);

/// Appends an arrow through the middle of each open gas cell.
void drawGas(DrawList& list, const BedView& view);

}  // namespace bedmix
