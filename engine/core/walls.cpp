// SPDX-License-Identifier: MIT
#include "engine/core/walls.h"

#include "engine/core/gas_grid.h"

#include <cmath>

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

}  // namespace

std::vector<WallSegment> bedWalls(const Scene& scene) {
  constexpr double farAbove = 100.0;  // m; higher than any particle is thrown
  const bool lid = scene.bed.top == BedTop::lid;
  const double top = lid ? scene.bed.height : scene.bed.height + farAbove;
  const double width = scene.bed.width;

  std::vector<Vec2> chain{{0.0, top}};
  for (const Vec2& p : floorLine(scene)) chain.push_back(p);
  chain.push_back({width, top});
  if (lid) chain.push_back({0.0, top});

  std::vector<WallSegment> walls;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) walls.push_back({chain[i], chain[i + 1], true, false});
  return walls;
}

}  // namespace bedmix
