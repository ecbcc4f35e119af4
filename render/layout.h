// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "render/camera.h"
#include "render/image.h"
#include "render/style.h"

#include <span>
#include <vector>

namespace bedmix {

/// Where things of one bed are in a picture. Depends on scene, style and size alone, so that a film is
/// steady.
struct Layout {
  Camera camera;
  Box view;         // where the bed may show, its surroundings included
  float em = 0.0f;  // px, height of the text
  Vec2f state;      // px, upper left corners of the HUD's two columns,
  Vec2f legend;     // above the bed or one below the other beside it
  Vec2f scaleBar;   // px, its lower left corner
};

/// Beds side by side, all to one scale, and the chart of their indices.
struct PictureLayout {
  std::vector<Layout> beds;
  Box chart;        // px; empty without the layer
  float em = 0.0f;  // px
};

/// Whole beds and, with the layers, the HUD above each or to its left, and the chart to the right of all or
/// below, whichever leaves the beds larger, in a part of a picture.
PictureLayout layoutPicture(std::span<const Scene> scenes, const Box& whole, const Style& style);
/// The whole of a picture.
Box wholeOf(Size size);
inline PictureLayout layoutPicture(std::span<const Scene> scenes, Size size, const Style& style) {
  return layoutPicture(scenes, wholeOf(size), style);
}
/// The same of one bed in a whole picture, of which it gives the layout.
Layout layoutPicture(const Scene& scene, Size size, const Style& style);

/// The height that pictures of the bed show, m: a tenth more than the bed where its top is open, which
/// the paper's beds stay below when the gas first lifts them.
double viewHeight(const Scene& scene);

}  // namespace bedmix
