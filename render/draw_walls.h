// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "render/colors.h"
#include "render/draw_list.h"

namespace bedmix {

/// Appends walls and lid as lines outside the room the particles have, the solid below an inclined
/// distributor, and the gas inlets: a perforated stretch of floor over arrows as long as the gas there is
/// fast. A floor that moves is
/// where it is at `time`, s; of a drum only itself is drawn.
void drawWalls(DrawList& list, const Scene& scene, const Camera& camera, float em,
               const Palette& palette = {}, double time = 0.0);

/// Room the inlets' arrows need below the bed, px.
float inletArrowHeight(const Scene& scene, float em);

}  // namespace bedmix
