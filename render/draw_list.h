// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/color.h"
#include "engine/core/vec2.h"
#include "render/camera.h"

#include <string>
#include <vector>

namespace bedmix {

struct Triangle {
  Vec2f a, b, c;  // px
  Rgba color;
};
struct Disc {
  Vec2f at;             // px
  float radius = 0.0f;  // px
  Rgba color;
};
/// Round ends; with a head, an arrow to `to` whose head is that long.
struct Line {
  Vec2f from, to;      // px
  float width = 1.0f;  // px
  float head = 0.0f;   // px
  Rgba color;
};
/// `anchor` says which point of the text lies at `at`: {0, 0} its top left, {1, 1} its bottom right corner.
struct Text {
  Vec2f at;  // px
  Vec2f anchor;
  Rgba color;
  std::string text;
  float size = 0.0f;  // px, height of the text; 0: the picture's
};

/// What is to be drawn, in pixels and without any OpenGL: triangles, then discs, lines and texts, each kind
/// in its order. Nothing but texts shows outside `clip`.
struct DrawList {
  Box clip;
  std::vector<Triangle> triangles;
  std::vector<Disc> discs;
  std::vector<Line> lines;
  std::vector<Text> texts;

  /// Empties it and keeps the memory.
  void clear();
};

}  // namespace bedmix
