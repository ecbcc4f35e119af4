// SPDX-License-Identifier: MIT
#pragma once

#include "render/draw_bed.h"

namespace bedmix {

/// Appends the open gas cells, coloured by voidage, pressure or gas speed.
void drawField(DrawList& list, const BedView& view, Layer field);

}  // namespace bedmix
