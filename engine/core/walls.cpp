// SPDX-License-Identifier: MIT
#include "engine/core/walls.h"

#include "engine/core/gas_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bedmix {

namespace {

/// The floor from left to right as a chain of points.
std::vector<Vec2> floorLine(const Scene& scene) {
  const double width = scene.bed.width;
  if (scene.floor.shape == FloorShape::straight || scene.floor.inclinationDeg == 0.0 || !scene.gas)
    return {{0.0, floorHeight(scene, 0.0)}, {width, floorHeight(scene, width)}};
  const GasGrid grid = makeGasGrid(scene);
  std::vector<Vec2> line;
  for (int c = 0; c < grid.columns; ++c) {
    const double y = grid.y[grid.lowestRow[c]];
    const bool sameStep = line.size() > 1 && line.back().y == y;
    if (sameStep) {
      line.back().x = grid.x[c + 1];
    } else {
      line.push_back({grid.x[c], y});
      line.push_back({grid.x[c + 1], y});
    }
  }
  return line;
}

void vibrate(WallSegment& floor, const VibrationSettings& vibration) {
  floor.amplitude = vibration.amplitude;
  floor.angularFrequency = 2.0 * std::numbers::pi * vibration.frequency;
}

/// The floor moves between the side walls, the first of the walls and the first of the last `behindFloor`;
/// these go down as far as it does.
void vibrate(std::vector<WallSegment>& walls, const VibrationSettings& vibration, std::size_t behindFloor) {
  WallSegment &left = walls.front(), &right = walls[walls.size() - behindFloor];
  left.b.y -= vibration.amplitude;
  right.a.y -= vibration.amplitude;
  for (std::size_t w = 1; w + behindFloor < walls.size(); ++w) vibrate(walls[w], vibration);
}

/// Floor and lid from x = from to x = to, m, of a bed without side walls.
std::vector<WallSegment> wallsWithoutSides(const Scene& scene, double from, double to) {
  std::vector<WallSegment> walls{{{from, 0.0}, {to, 0.0}}};
  if (const auto& vibration = scene.floor.vibration) vibrate(walls.front(), *vibration);
  if (scene.bed.top == BedTop::lid) walls.push_back({{to, scene.bed.height}, {from, scene.bed.height}});
  return walls;
}

}  // namespace

WallSegment wallAt(const WallSegment& wall, double time) {
  WallSegment now = wall;
  const double rise = wall.amplitude * std::sin(wall.angularFrequency * time);
  now.a.y += rise;
  now.b.y += rise;
  return now;
}

Vec2 nearestOn(const WallSegment& wall, Vec2 p) {
  constexpr double tiny = 1e-300;  // stands for zero
  const Vec2 along = wall.b - wall.a;
  const double t = dot(p - wall.a, along) / std::max(dot(along, along), tiny);
  const Vec2 core = wall.a + along * std::clamp(t, 0.0, 1.0);
  if (wall.radius == 0.0) return core;
  return core + (wall.radius / std::max(norm(p - core), tiny)) * (p - core);
}

std::vector<WallSegment> bedWalls(const Scene& scene) {
  constexpr double farAbove = 100.0;  // m; higher than any particle is thrown
  const bool lid = scene.bed.top == BedTop::lid;
  const double top = lid ? scene.bed.height : scene.bed.height + farAbove;
  const double width = scene.bed.width;
  if (scene.bed.sides == BedSides::periodic) return wallsWithoutSides(scene, 0.0, width);

  std::vector<Vec2> chain{{0.0, top}};
  for (const Vec2& p : floorLine(scene)) chain.push_back(p);
  chain.push_back({width, top});
  if (lid) chain.push_back({0.0, top});

  std::vector<WallSegment> walls;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) walls.push_back({chain[i], chain[i + 1], true, false});
  if (const auto& vibration = scene.floor.vibration) vibrate(walls, *vibration, lid ? 2 : 1);
  return walls;
}

std::vector<WallSegment> obstacleWalls(const Scene& scene) {
  std::vector<WallSegment> walls;
  const auto isTaken = [&walls](Vec2 end) {
    return std::any_of(walls.begin(), walls.end(),
                       [&](const WallSegment& w) { return !isCircle(w) && (w.a == end || w.b == end); });
  };
  for (const ObstacleSettings& o : scene.obstacles) {
    WallSegment wall;
    if (o.shape != ObstacleShape::segment) {
      wall.a = wall.b = {o.x.value_or(0.0), o.y.value_or(0.0)};
      wall.radius = o.radius.value_or(0.0);
      wall.spin = o.spinRpm.value_or(0.0) * std::numbers::pi / 30.0;
    } else {
      wall.a = {o.x1.value_or(0.0), o.y1.value_or(0.0)};
      wall.b = {o.x2.value_or(0.0), o.y2.value_or(0.0)};
      wall.radius = 0.5 * o.thickness.value_or(0.0);
      wall.ownsA = !isTaken(wall.a);
      wall.ownsB = !isTaken(wall.b);
    }
    walls.push_back(wall);
  }
  return walls;
}

bool hasDrum(const Scene& scene) {
  return std::any_of(scene.obstacles.begin(), scene.obstacles.end(),
                     [](const ObstacleSettings& o) { return o.shape == ObstacleShape::drum; });
}

std::vector<WallSegment> allWalls(const Scene& scene) {
  const double width = scene.bed.width;
  std::vector<WallSegment> walls =
      scene.bed.sides == BedSides::periodic ? wallsWithoutSides(scene, -width, 2.0 * width) : bedWalls(scene);
  const std::vector<WallSegment> obstacles = obstacleWalls(scene);
  walls.insert(walls.end(), obstacles.begin(), obstacles.end());
  return walls;
}

}  // namespace bedmix
