// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "render/draw_list.h"
#include "render/layout.h"

#include <span>

namespace bedmix {

/// What the HUD says: first the state (time, particles, gas supply, mixing indices now), then the legend of
/// the layers. Both numbers depend on scene and layers only, and
/// on whether the bed is named.
struct HudRowCount {
  int state = 0;
  int legend = 0;
};
HudRowCount hudRowCount(const Scene& scene, Layers layers, bool isNamed = false);
inline constexpr float hudLine = 1.35f;  // em, distance of rows

/// Appends the HUD's rows, the scale bar, and how many particles are above the view if any are.
/// `name` tells one of several beds from the others; none: no row for it.
void drawHud(DrawList& list, const Scene& scene, const Frame& frame, Layers layers, const Layout& layout,
             const std::string& name = "");

/// Appends the legend alone, its upper left corner at `at`: as many rows as hudRowCount() says.
void drawLegend(DrawList& list, const Scene& scene, Layers layers, const Camera& camera, Vec2f at, float em);

/// "t = 0.50 s" with this many decimals.
std::string timeLabel(double time, int decimals);
/// Fewest decimals, at least one, that write each of the times in full.
int timeDecimals(std::span<const double> times);

}  // namespace bedmix
