// SPDX-License-Identifier: MIT
#include "render/draw_obstacles.h"

#include "engine/core/walls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bedmix {

namespace {

constexpr int sides = 128;  // of what stands for a circle

void drawDrum(DrawList& list, Vec2f centre, float radius, float width, Rgba color) {
  const auto at = [&](int k) {
    const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(k) / sides;
    return centre + Vec2f{std::cos(angle), std::sin(angle)} * (radius + 0.5f * width);
  };
  for (int k = 0; k < sides; ++k) list.lines.push_back({at(k), at(k + 1), width, 0.0f, color});
}

}  // namespace

void drawObstacles(DrawList& list, const Scene& scene, const Camera& camera, float width,
                   const Palette& palette) {
  const std::vector<WallSegment> walls = obstacleWalls(scene);
  for (std::size_t o = 0; o < walls.size(); ++o) {
    const Vec2f a = camera.toPixel(walls[o].a), b = camera.toPixel(walls[o].b);
    const float radius = camera.length(walls[o].radius);
    if (scene.obstacles[o].shape == ObstacleShape::drum) {
      drawDrum(list, a, radius, width, palette.wall);
      continue;
    }
    // A circle is a line of no length.
    list.lines.push_back({a, b, std::max(2.0f * radius, 0.5f * width), 0.0f, palette.wall});
    const float inner = 2.0f * (radius - 0.5f * width);
    if (inner > 0.0f) list.lines.push_back({a, b, inner, 0.0f, palette.distributor});
  }
}

}  // namespace bedmix
