// SPDX-License-Identifier: MIT
#pragma once

#include "render/draw_bed.h"

namespace bedmix {

/// Appends the line along which the voidage is the style's: linear between the centres of the gas cells
/// (marching squares), level from there to walls and outlet. There is none where a blocked cell is a corner.
void drawBubbles(DrawList& list, const BedView& view);

/// Width of that line, px.
float bubbleWidth(float em);

}  // namespace bedmix
