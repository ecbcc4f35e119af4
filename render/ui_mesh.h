// SPDX-License-Identifier: MIT
#pragma once

#include "render/camera.h"
#include "render/image.h"

#include <cstdint>
#include <vector>

namespace bedmix {

/// Coverage of a font's glyphs, a byte a pixel, for the texture the user interface draws from.
struct GlyphSheet {
  Size size;
  std::vector<std::uint8_t> coverage;
};

struct UiVertex {
  Vec2f at;  // px
  Vec2f uv;  // in the glyph sheet
  Rgba color;
};
/// `count` indices from `first` on, each counted from `base`, clipped to a box.
struct UiCommand {
  Box clip;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t base = 0;
};
/// What the user interface looks like at one instant, free of the library that made it.
struct UiMesh {
  std::vector<UiVertex> vertices;
  std::vector<std::uint16_t> indices;
  std::vector<UiCommand> commands;
};

}  // namespace bedmix
