// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/color.h"

#include <cstdint>
#include <vector>

namespace bedmix {

/// Of a picture, in pixels.
struct Size {
  int width = 0;
  int height = 0;
  friend bool operator==(Size, Size) = default;
};

/// A picture: 4 bytes a pixel (red, green, blue, alpha), top row first, no padding.
struct Image {
  Size size;
  std::vector<std::uint8_t> rgba;

  void resize(Size to) {
    size = to;
    rgba.resize(4 * static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height));
  }
  Rgba at(int x, int y) const {
    const std::uint8_t* p =
        &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + x)];
    return {p[0], p[1], p[2], p[3]};
  }
};

}  // namespace bedmix
