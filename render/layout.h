// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "render/camera.h"
#include "render/image.h"
#include "render/style.h"

namespace bedmix {

/// Where things are in a picture of one bed. Depends on scene, style and size alone, so that a film is
/// steady.
struct Layout {
  Camera camera;
  Box view;         // where the bed may show, its surroundings included
  float em = 0.0f;  // px, height of the text
  Vec2f state;      // px, upper left corners of the HUD's two columns,
  Vec2f legend;     // above the bed or one below the other beside it
  Vec2f scaleBar;   // px, its lower left corner
};

/// The whole bed and, with the layer, the HUD above it or to its left, whichever leaves the bed larger.
Layout layoutPicture(const Scene& scene, Size size, const Style& style);

/// The height that pictures of the bed show, m: a tenth more than the bed where its top is open, which
/// the paper's beds stay below when the gas first lifts them.
double viewHeight(const Scene& scene);

}  // namespace bedmix
