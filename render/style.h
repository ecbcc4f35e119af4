// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

#include <initializer_list>

namespace bedmix {

/// How a bed is drawn.
struct Style : PictureSettings {
  /// Whether pictures show what was before their time.
  bool showsHistory() const {
    return layers.has(Layer::curve) || layers.has(Layer::trails) ||
           (layers.has(Layer::particles) && hasClasses(color));
  }

  Style() = default;
  Style(PictureSettings settings) : PictureSettings(std::move(settings)) {}  // NOLINT: they are one
  Style(Layers shown) { layers = shown; }  // NOLINT: layers in their usual style
  Style(std::initializer_list<Layer> shown) { layers = shown; }
};

/// The scene's own style, or the usual one.
inline Style styleOf(const Scene& scene) { return scene.pictures ? Style(*scene.pictures) : Style(); }

}  // namespace bedmix
