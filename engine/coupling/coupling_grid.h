// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"
#include "engine/core/scene.h"
#include "engine/core/thread_team.h"
#include "engine/coupling/grid_axis.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bedmix {

/// The gas grid as particles see it: framed by ghosts, so that what they take from the gas and give to it
/// knows no walls. Cells, upright faces and level faces are each numbered row by row as points, `stride` to a
/// row: cell (i, j) is point (i + 1, j + 1), upright face (i, j) point (i, j + 1), level face (i, j) point (i
/// + 1, j). Each point has an owner that it copies and that gets what is given to it: itself, or, for a ghost
/// beyond the walls or below the distributor, the wall's cell or face or the lowest open one of its column.
struct CouplingGrid {
  CouplingGrid(const Scene& scene, const GasGrid& grid);

  std::size_t points() const { return cells.size(); }
  /// A member's part of the points' columns. Owners in different parts are different, too.
  Range columnsOf(const ThreadTeam& team, int member) const;

  /// Column and row of a cell or face.
  struct Place {
    std::int32_t i, j;
  };
  std::int32_t point(Place cell) const { return (cell.j + 1) * stride + cell.i + 1; }

  GridAxis x, y;
  std::int32_t stride, rows;                           // of points
  std::vector<Place> cells, uprightFaces, levelFaces;  // owners, per point
  double perDiameter;                                  // 1/m
  double particleVolume;                               // m3
  /// The share of a particle at height y that is coupled is 3 s^2 - 2 s^3, s = taperShift - y taperSlope
  /// within 0 and 1: it fades towards an open top.
  double taperShift = 1.0, taperSlope = 0.0;
};

}  // namespace bedmix
