// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"
#include "engine/core/scene.h"
#include "engine/core/thread_team.h"
#include "engine/coupling/grid_axis.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bedmix {

/// The gas grid as particles see it: framed by ghosts, so that what they take from the gas and give to it
/// knows no walls. Cells, upright faces and level faces are each numbered row by row as points, `stride` to a
/// row: cell (i, j) is the point in column i + 1 and row j + 1, upright face (i, j) that in (i, j + 1), level
/// face (i, j) that in (i + 1, j). Each point has an owner whose values it has and that gets what is given to
/// it: itself, or, for a ghost beyond the walls or below the distributor, the wall's cell or face or the
/// lowest open one of its column; where there are obstacles, for one in a blocked cell the nearest. Beyond
/// sides that are periodic it is the cell or face at the other side.
class CouplingGrid {
 public:
  /// `gasGrid` must outlive this.
  CouplingGrid(const Scene& scene, const GasGrid& gasGrid);

  /// Column and row.
  struct Place {
    std::int32_t i, j;
  };
  // Owners of a point, as cells and faces of the gas grid.
  Place cellOf(Place point) const;
  Place uprightFaceOf(Place point) const;
  Place levelFaceOf(Place point) const;

  std::size_t points() const { return cellOwner_.size(); }
  std::size_t point(Place cell) const {
    const std::int32_t number = (cell.j + 1) * stride + cell.i + 1;
    return static_cast<std::size_t>(number);
  }
  /// A member's part of the points' columns, of which with obstacles or periodic sides the first has all.
  /// Owners in different parts are different, too.
  Range columnsOf(const ThreadTeam& team, int member) const;
  /// Calls visit(point) for the points in a part of the columns.
  template <class Visit>
  void forPoints(Range columns, Visit&& visit) const {
    for (std::size_t row = 0; row < points(); row += static_cast<std::size_t>(stride))
      for (std::size_t k = row + columns.begin; k < row + columns.end; ++k) visit(k);
  }
  /// Calls visit(point, cell) for the cells in a part of the points' columns, blocked ones too.
  template <class Visit>
  void forCells(Range columns, Visit&& visit) const {
    const auto begin = std::max(static_cast<std::int32_t>(columns.begin) - 1, 0);
    const auto end = std::min(static_cast<std::int32_t>(columns.end) - 1, x.cells);
    for (std::int32_t j = 0; j < y.cells; ++j)
      for (std::int32_t i = begin; i < end; ++i) visit(point({i, j}), Place{i, j});
  }
  /// The point of the cell that owns a point.
  std::size_t cellOwner(std::size_t point) const { return static_cast<std::size_t>(cellOwner_[point]); }

  GridAxis x, y;
  std::int32_t stride, rows;  // of points
  double perDiameter;         // 1/m
  double particleVolume;      // m3
  /// The share of a particle at height y that is coupled is 3 s^2 - 2 s^3, s = taperShift - y taperSlope
  /// within 0 and 1: it fades towards an open top.
  double taperShift = 1.0, taperSlope = 0.0;

 private:
  /// Of the cells, that a point is in.
  std::int32_t columnOf(Place point) const;

  const GasGrid& gas_;
  std::vector<std::int32_t> cellOwner_;  // per point
};

}  // namespace bedmix
