// SPDX-License-Identifier: MIT
#include "render/shapes.h"

#include <algorithm>

namespace bedmix {

bool isOutside(const Box& clip, Vec2f at, float radius) {
  return at.x + radius <= clip.left || at.x - radius >= clip.right || at.y + radius <= clip.top ||
         at.y - radius >= clip.bottom;
}

void addRectangle(DrawList& list, Vec2f a, Vec2f b, Rgba color) {
  const Vec2f c{b.x, a.y}, d{a.x, b.y};
  list.triangles.push_back({a, c, b, color});
  list.triangles.push_back({a, b, d, color});
}

void addArrow(DrawList& list, Vec2f tail, Vec2f shift, float width, Rgba color) {
  const float length = norm(shift);
  if (!(length >= 1.0f)) return;
  list.lines.push_back({tail, tail + shift, width, std::min(0.6f * length, 4.0f * width), color});
}

void addRims(DrawList& list, std::size_t first, float widest, Rgba color) {
  const std::size_t count = list.lines.size() - first;
  list.lines.resize(list.lines.size() + count);
  const auto begin = list.lines.begin() + static_cast<std::ptrdiff_t>(first);
  std::copy_backward(begin, begin + static_cast<std::ptrdiff_t>(count), list.lines.end());
  for (std::size_t i = first; i < first + count; ++i) {
    Line& line = list.lines[i];
    const float rim = std::min(0.5f * line.width, widest);
    if (line.head > 0.0f) {
      // 2.7 rims beyond an arrow's tip are one rim beside its head's slanting edges.
      const Vec2f along = (line.to - line.from) * (1.0f / norm(line.to - line.from));
      line.to += along * (2.7f * rim);
      line.head += 3.7f * rim;
    }
    line.width += 2.0f * rim;
    line.color = color;
  }
}

}  // namespace bedmix
