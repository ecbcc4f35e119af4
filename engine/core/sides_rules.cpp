// SPDX-License-Identifier: MIT
#include "engine/core/sides_rules.h"

#include "engine/core/particle_list.h"
#include "engine/core/walls.h"

#include <fmt/format.h>

#include <algorithm>

namespace bedmix {

namespace {

constexpr double rounding = 1e-9;  // as in scene_rules.cpp
/// Diameters, with the range of cohesion: from here on no particle meets another at both of its sides, and
/// neighbours are found in cells of their own.
constexpr double narrowest = 5.0;
/// Likewise, from an obstacle to the sides: particles may hang over these by less than that.
constexpr double obstacleDistance = 2.0;
constexpr std::int64_t fewestColumns = 4;  // of gas cells

/// The stretch of the width that it takes.
struct Extent {
  double left, right;
};
Extent extentOf(const WallSegment& wall) {
  return {std::min(wall.a.x, wall.b.x) - wall.radius, std::max(wall.a.x, wall.b.x) + wall.radius};
}

void addColumns(const Scene& scene, std::vector<Contradiction>& broken) {
  const std::vector<GridSpan>& spans = scene.gas->grid.columns;
  std::int64_t columns = 0;
  for (const GridSpan& span : spans) columns += span.count;
  if (columns < fewestColumns)
    broken.push_back({"gas.grid.columns",
                      fmt::format("periodic sides take {} columns of gas cells at least, and there are {}",
                                  fewestColumns, columns),
                      {"bed.sides"}});
  const double first = spans.empty() ? 0.0 : spans.front().size,
               last = spans.empty() ? 0.0 : spans.back().size;
  if (std::abs(first - last) > rounding * first)
    broken.push_back(
        {"gas.grid.columns",
         fmt::format("with periodic sides the last column is the first one's neighbour, and they "
                     "must be as wide as each other; they are {} and {} m",
                     last, first),
         {"bed.sides"}});
}

}  // namespace

std::vector<Contradiction> sidesContradictions(const Scene& scene) {
  std::vector<Contradiction> broken;
  if (scene.bed.sides != BedSides::periodic) return broken;
  const double reach = particleRange(scene).largest + cohesionRange(scene);
  if (scene.bed.width < narrowest * reach)
    broken.push_back({"bed.width",
                      fmt::format("a bed with periodic sides must be wider than {} diameters (with the range "
                                  "of [cohesion]), so that no two particles meet at both sides: {:.4g} m",
                                  narrowest, narrowest * reach),
                      {"bed.sides", "particles.diameter"}});
  if (scene.floor.inclinationDeg != 0.0)
    broken.push_back({"floor.inclination_deg",
                      "with periodic sides the floor goes on at the other side, where it would jump; let it "
                      "be level",
                      {"bed.sides"}});
  const std::vector<WallSegment> obstacles = obstacleWalls(scene);
  const double distance = obstacleDistance * reach;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const std::string path = fmt::format("obstacles.{}", i);
    if (scene.obstacles[i].shape == ObstacleShape::drum) {
      broken.push_back({path + ".shape",
                        "a drum holds all particles, and none comes to the sides: leave "
                        "bed.sides = \"walls\"",
                        {"bed.sides"}});
      continue;
    }
    const Extent extent = extentOf(obstacles[i]);
    if (extent.left >= distance && extent.right <= scene.bed.width - distance) continue;
    broken.push_back(
        {path,
         fmt::format("it reaches from x = {:.4g} to {:.4g} m; with periodic sides obstacles must "
                     "stay {:.4g} m, {} diameters, away from x = 0 and x = {} m",
                     extent.left, extent.right, distance, obstacleDistance, scene.bed.width),
         {"bed.sides", "bed.width"}});
  }
  if (scene.gas) addColumns(scene, broken);
  return broken;
}

}  // namespace bedmix
