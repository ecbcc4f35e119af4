// SPDX-License-Identifier: MIT
#pragma once

#include "render/draw_bed.h"

#include <vector>

namespace bedmix {

/// Lines along the gas velocity, bilinear between the centres of open cells: evenly spaced, about a cell
/// apart, from seeds in a fixed order (after Jobard & Lefer 1997). They end at walls, outlet and blocked
/// cells, where the gas stands still, and close to another line. Points in m, downstream.
std::vector<std::vector<Vec2>> gasStreamlines(const Frame& frame, const Scene& scene);

/// Appends these, with an arrow's head in the middle of each.
void drawStreamlines(DrawList& list, const BedView& view);

/// Width of a streamline, px.
float streamlineWidth(float em);

}  // namespace bedmix
