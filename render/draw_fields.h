// SPDX-License-Identifier: MIT
#pragma once

#include "render/draw_bed.h"

namespace bedmix {

/// Colour of t in [0, 1] in such a field.
Rgba fieldColor(Layer field, double t);

/// Appends the open gas cells, coloured by voidage, pressure or gas speed.
void drawField(DrawList& list, const BedView& view, Layer field);

}  // namespace bedmix
