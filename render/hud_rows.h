// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "render/draw_list.h"
#include "render/layout.h"
#include "render/style.h"

#include <span>

namespace bedmix {

/// What the HUD says: first the state (time, particles, gas supply, mixing indices now), then the legend of
/// the layers. Both numbers depend on scene, style and whether the bed is named.
struct HudRowCount {
  int state = 0;
  int legend = 0;
};
HudRowCount hudRowCount(const Scene& scene, const Style& style, bool isNamed = false);
inline constexpr float hudLine = 1.35f;  // em, distance of rows

/// Appends the HUD's rows, the scale bar, and how many particles are above the view if any are.
/// `name` tells one of several beds from the others; none: no row for it.
void drawHud(DrawList& list, const Scene& scene, const Frame& frame, const Style& style, const Layout& layout,
             const std::string& name = "");

/// "t = 0.50 s" with this many decimals.
std::string timeLabel(double time, int decimals);
/// Fewest decimals, at least one, that write each of the times in full.
int timeDecimals(std::span<const double> times);

}  // namespace bedmix
