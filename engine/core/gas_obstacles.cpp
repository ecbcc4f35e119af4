// SPDX-License-Identifier: MIT
#include "engine/core/gas_obstacles.h"

#include "engine/core/walls.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>

namespace bedmix {

namespace {

/// Whether a straight line from `a` to `b` goes through the open rectangle.
bool crosses(Vec2 a, Vec2 b, Vec2 low, Vec2 high) {
  double from = 0.0, to = 1.0;
  for (const auto& [start, way, least, most] :
       {std::array{a.x, b.x - a.x, low.x, high.x}, std::array{a.y, b.y - a.y, low.y, high.y}}) {
    if (way == 0.0) {
      if (start <= least || start >= most) return false;
      continue;
    }
    const double first = (least - start) / way, second = (most - start) / way;
    from = std::max(from, std::min(first, second));
    to = std::min(to, std::max(first, second));
  }
  return from < to;
}

bool isBlocked(const WallSegment& wall, Vec2 low, Vec2 high) {
  if (!isCircle(wall)) return wall.radius > 0.0 && crosses(wall.a, wall.b, low, high);
  const Vec2 from = 0.5 * (low + high) - wall.a;
  return dot(from, from) < wall.radius * wall.radius;
}

/// Cells that gas can reach from the top.
std::vector<std::uint8_t> connectedToTop(const GasGrid& grid, const std::vector<std::uint8_t>& blocked) {
  std::vector<std::uint8_t> connected(blocked.size(), 0);
  std::queue<std::pair<int, int>> front;
  const auto reach = [&](int i, int j) {
    if (grid.repeats) i = grid.columnAround(i);
    if (i < 0 || i >= grid.columns || j < 0 || j >= grid.rows) return;
    const std::size_t cell = grid.cell(i, j);
    if (blocked[cell] != 0 || connected[cell] != 0) return;
    connected[cell] = 1;
    front.emplace(i, j);
  };
  for (int i = 0; i < grid.columns; ++i) reach(i, grid.rows - 1);
  while (!front.empty()) {
    const auto [i, j] = front.front();
    front.pop();
    reach(i - 1, j);
    reach(i + 1, j);
    reach(i, j - 1);
    reach(i, j + 1);
  }
  return connected;
}

/// The open cell whose centre is nearest; of several the first in the order of cells.
std::int32_t nearestOpen(const GasGrid& grid, const std::vector<std::uint8_t>& open, int column, int row) {
  const auto centre = [&grid](int i, int j) {
    return Vec2{0.5 * (grid.x[i] + grid.x[i + 1]), 0.5 * (grid.y[j] + grid.y[j + 1])};
  };
  const Vec2 here = centre(column, row);
  double nearest = std::numeric_limits<double>::infinity();
  std::int32_t found = -1;
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      if (open[grid.cell(i, j)] == 0) continue;
      const Vec2 apart = centre(i, j) - here;
      if (!(dot(apart, apart) < nearest)) continue;
      nearest = dot(apart, apart);
      found = static_cast<std::int32_t>(grid.cell(i, j));
    }
  return found;
}

/// Whether a point lies in a circle or in a plate with round ends.
bool isWithin(const WallSegment& wall, Vec2 at) {
  const Vec2 along = wall.b - wall.a, from = at - wall.a;
  const double length2 = dot(along, along);
  const double place = length2 > 0.0 ? std::clamp(dot(from, along) / length2, 0.0, 1.0) : 0.0;
  const Vec2 apart = from - place * along;
  return dot(apart, apart) < wall.radius * wall.radius;
}

/// The share of a cell that is neither within an obstacle nor below the distributor.
double freeShare(const Scene& scene, const std::vector<WallSegment>& obstacles, Vec2 low, Vec2 high) {
  constexpr int parts = 16;  // along each side
  int isFree = 0;
  for (int k = 0; k < parts * parts; ++k) {
    const Vec2 share{(k % parts + 0.5) / parts, (k / parts + 0.5) / parts};
    const Vec2 at{low.x + share.x * (high.x - low.x), low.y + share.y * (high.y - low.y)};
    isFree += at.y >= floorHeight(scene, at.x) &&
              std::none_of(obstacles.begin(), obstacles.end(),
                           [&](const WallSegment& o) { return isWithin(o, at); });
  }
  return static_cast<double>(isFree) / (parts * parts);
}

/// What open cells and those they stand for hold, but no less than a tenth of an open cell.
void findFreeVolumes(const Scene& scene, const std::vector<WallSegment>& obstacles, GasGrid& grid) {
  constexpr double least = 0.1;
  grid.freeVolume.assign(grid.cells(), 0.0);
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i)
      grid.freeVolume[grid.openCellFor(i, j)] +=
          grid.volume(i, j) *
          freeShare(scene, obstacles, {grid.x[i], grid.y[j]}, {grid.x[i + 1], grid.y[j + 1]});
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      double& room = grid.freeVolume[grid.cell(i, j)];
      room = std::max(room, least * grid.volume(i, j));
    }
}

}  // namespace

void blockCells(const Scene& scene, GasGrid& grid) {
  const std::vector<WallSegment> obstacles = obstacleWalls(scene);
  std::vector<std::uint8_t> blocked(grid.cells(), 0);
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i)
      blocked[grid.cell(i, j)] =
          j < grid.lowestRow[i] || std::any_of(obstacles.begin(), obstacles.end(), [&](const WallSegment& o) {
            return isBlocked(o, {grid.x[i], grid.y[j]}, {grid.x[i + 1], grid.y[j + 1]});
          });
  const std::vector<std::uint8_t> open = connectedToTop(grid, blocked);
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      const std::size_t cell = grid.cell(i, j);
      grid.openCell.push_back(open[cell] != 0 ? static_cast<std::int32_t>(cell)
                                              : nearestOpen(grid, open, i, j));
    }
  findFreeVolumes(scene, obstacles, grid);
  for (int i = 0; i < grid.columns; ++i)
    if (!grid.open(i, grid.lowestRow[i])) grid.inletFlux[i] = 0.0;
}

}  // namespace bedmix
