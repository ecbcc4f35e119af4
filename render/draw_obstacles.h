// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "render/camera.h"
#include "render/colors.h"
#include "render/draw_list.h"

namespace bedmix {

/// Appends tubes and thick plates as solids with a rim within them, thin plates as lines, and drums as lines
/// of `width` px around the room the particles have.
void drawObstacles(DrawList& list, const Scene& scene, const Camera& camera, float width,
                   const Palette& palette);

}  // namespace bedmix
