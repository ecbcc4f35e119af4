// SPDX-License-Identifier: MIT
#pragma once

#include "render/layers.h"

namespace bedmix {

/// How a bed is drawn.
struct Style {
  Layers layers = defaultLayers;

  /// Whether pictures show what was before their time.
  bool showsHistory() const { return layers.has(Layer::curve); }

  Style() = default;
  Style(Layers shown) : layers(shown) {}  // NOLINT: layers in their usual style
  Style(std::initializer_list<Layer> shown) : layers(shown) {}
};

}  // namespace bedmix
