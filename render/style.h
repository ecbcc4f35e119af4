// SPDX-License-Identifier: MIT
#pragma once

#include "render/layers.h"

namespace bedmix {

/// How a bed is drawn.
struct Style {
  Layers layers = defaultLayers;

  Style() = default;
  Style(Layers shown) : layers(shown) {}  // NOLINT: layers in their usual style
  Style(std::initializer_list<Layer> shown) : layers(shown) {}
};

}  // namespace bedmix
