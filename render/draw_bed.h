// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "render/colors.h"
#include "render/draw_list.h"
#include "render/history.h"
#include "render/style.h"

namespace bedmix {

/// What every layer is drawn from. `em`: height of the picture's text, px, which line widths follow.
struct BedView {
  const Scene& scene;
  const Frame& frame;
  const Camera& camera;
  const Style& style;
  const Palette& palette;
  float em;
};

/// Appends the bed's layers (all but HUD and curve) as the camera sees them. Discs that lie wholly outside
/// `list.clip` are left out. A layer of the gas needs a frame with gas; trails and colours of the start need
/// a history that has seen the frame.
void drawBed(DrawList& list, const Scene& scene, const Frame& frame, const Camera& camera, const Style& style,
             float em, const History& history = {});

/// Appends a scale bar of a round length and its label, its left end and lower edge at `at`.
void drawScaleBar(DrawList& list, const Scene& scene, const Camera& camera, Vec2f at, float em,
                  Rgba color = ink);

}  // namespace bedmix
