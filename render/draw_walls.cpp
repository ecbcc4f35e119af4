// SPDX-License-Identifier: MIT
#include "render/draw_walls.h"

#include "engine/core/walls.h"
#include "render/draw_obstacles.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr float longestArrow = 1.5f;  // em

float wallWidth(float em) { return std::max(2.0f, 0.2f * em); }

/// Segments run from left to right only along the floor: down the left wall, along it, up the right wall.
bool isFloor(const WallSegment& wall) { return wall.b.x > wall.a.x; }

double heightOn(const WallSegment& floor, double x) {
  return floor.a.y + (floor.b.y - floor.a.y) * (x - floor.a.x) / (floor.b.x - floor.a.x);
}

void drawSegment(DrawList& list, const WallSegment& wall, const Camera& camera, float width, Rgba color) {
  const double top = camera.heightAt(list.clip.top);
  const Vec2f from = camera.toPixel(Vec2{wall.a.x, std::min(wall.a.y, top)});
  const Vec2f to = camera.toPixel(Vec2{wall.b.x, std::min(wall.b.y, top)});
  const Vec2f along = to - from;
  const float length = norm(along);
  if (!(length > 0.0f)) return;
  // The bed lies to the left of the way; half a line's width to the right leaves the particles their room.
  const Vec2f outward = Vec2f{-along.y, along.x} * (0.5f * width / length);
  list.lines.push_back({from + outward, to + outward, width, 0.0f, color});
}

/// What is below a raised floor.
void drawSolid(DrawList& list, const WallSegment& floor, const Camera& camera, Rgba color) {
  const Vec2f a = camera.toPixel(floor.a), b = camera.toPixel(floor.b);
  if (a.y >= camera.origin.y && b.y >= camera.origin.y) return;  // one that moves may be lower
  const Vec2f belowA{a.x, camera.origin.y}, belowB{b.x, camera.origin.y};
  list.triangles.push_back({a, b, belowB, color});
  list.triangles.push_back({a, belowB, belowA, color});
}

/// From x = from to x = to (m) of a floor segment: holes in the plate and the gas that comes through them.
void drawInlet(DrawList& list, const WallSegment& floor, double from, double to, float arrow,
               const Camera& camera, float em, const Palette& palette) {
  const float width = wallWidth(em);
  const float span = camera.length(to - from);
  const auto on = [&](double x) {
    return camera.toPixel(Vec2{x, heightOn(floor, x)}) + Vec2f{0.0f, 0.5f * width};
  };
  const int holes = std::max(1, static_cast<int>(span / (2.0f * width)));
  for (int i = 0; i < holes; ++i) {
    const Vec2f hole = on(from + (i + 0.5) * (to - from) / holes);
    list.lines.push_back({hole, hole, 0.6f * width, 0.0f, palette.ground});
  }
  const int arrows = std::max(1, static_cast<int>(span / (1.2f * em)));
  for (int i = 0; i < arrows; ++i) {
    const Vec2f tip = on(from + (i + 0.5) * (to - from) / arrows) + Vec2f{0.0f, width};
    list.lines.push_back(
        {tip + Vec2f{0.0f, arrow}, tip, std::max(1.0f, 0.1f * em), std::min(0.5f * em, arrow), palette.gas});
  }
}

}  // namespace

void drawWalls(DrawList& list, const Scene& scene, const Camera& camera, float em, const Palette& palette,
               double time) {
  drawObstacles(list, scene, camera, wallWidth(em), palette);
  if (hasDrum(scene)) return;  // nobody meets the others
  std::vector<WallSegment> walls = bedWalls(scene);
  for (WallSegment& wall : walls) wall = wallAt(wall, time);
  for (const WallSegment& wall : walls) {
    if (isFloor(wall)) drawSolid(list, wall, camera, palette.distributor);
    drawSegment(list, wall, camera, wallWidth(em), palette.wall);
  }
  const double corner = floorHeight(scene, scene.bed.width);
  if (corner > 0.0)  // the right wall goes on beside the solid
    drawSegment(list, {{scene.bed.width, 0.0}, {scene.bed.width, corner}}, camera, wallWidth(em),
                palette.wall);
  if (!scene.gas) return;
  const double fastest = fastestInlet(scene);
  for (const Inlet& inlet : scene.gas->inlets) {
    const double velocity = inletVelocity(scene, inlet);
    if (!(velocity > 0.0)) continue;
    const float arrow = longestArrow * em * static_cast<float>(velocity / fastest);
    for (const WallSegment& wall : walls) {
      const double from = std::max(inlet.from, wall.a.x), to = std::min(inlet.to, wall.b.x);
      if (isFloor(wall) && to > from) drawInlet(list, wall, from, to, arrow, camera, em, palette);
    }
  }
}

float inletArrowHeight(const Scene& scene, float em) {
  return scene.gas ? longestArrow * em + 2.0f * wallWidth(em) : 0.0f;
}

}  // namespace bedmix
