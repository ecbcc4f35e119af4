// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "render/draw_list.h"
#include "render/style.h"

namespace bedmix {

/// Rows of the legend.
int legendRows(const Style& style);

/// Appends what colours, arrows and lines of the style's layers mean, in rows from `at` on, px.
void drawLegend(DrawList& list, Vec2f at, const Scene& scene, const Style& style, const Camera& camera,
                float em);

}  // namespace bedmix
