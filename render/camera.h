// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/vec2.h"

namespace bedmix {

/// A part of a picture, px from its top left corner, y down.
struct Box {
  float left = 0.0f, top = 0.0f, right = 0.0f, bottom = 0.0f;
  float width() const { return right - left; }
  float height() const { return bottom - top; }
  friend bool operator==(Box, Box) = default;
};

/// From metres in the bed to pixels in the picture.
struct Camera {
  Vec2f origin;        // px, where the bed's lower left corner is
  float scale = 1.0f;  // px per m

  Vec2f toPixel(Vec2f metres) const { return {origin.x + scale * metres.x, origin.y - scale * metres.y}; }
  Vec2f toPixel(Vec2 metres) const { return toPixel(toFloat(metres)); }
  float length(double metres) const { return scale * static_cast<float>(metres); }
  double heightAt(float pixelY) const { return static_cast<double>((origin.y - pixelY) / scale); }
};

}  // namespace bedmix
