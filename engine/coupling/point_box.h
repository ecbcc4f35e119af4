// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/vec2.h"
#include "engine/coupling/batch.h"
#include "engine/coupling/coupling_grid.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace bedmix {

/// A rectangle of a grid's points.
struct PointBox {
  std::int32_t firstColumn = 0, firstRow = 0, columns = 0, rows = 0;

  std::size_t points() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

/// All points around some particles: the cells and faces they may take from or give to.
PointBox boxAround(const CouplingGrid& grid, std::span<const Vec2> particles);

/// What a block of particles gives to the points around it; T() is nothing.
template <class T>
class BlockSum {
 public:
  /// Covers all points around `particles` with nothing at any.
  void clear(const CouplingGrid& grid, std::span<const Vec2> particles) {
    box_ = boxAround(grid, particles);
    sums_.assign(box_.points(), T());
  }
  Numbering numbering() const { return {box_.columns, box_.firstRow * box_.columns + box_.firstColumn}; }
  T& operator[](std::int32_t index) { return sums_[static_cast<std::size_t>(index)]; }
  /// Calls visit(point of the grid, its sum) for the points in `range` of the grid's columns.
  template <class Visit>
  void forPoints(const CouplingGrid& grid, Range range, Visit&& visit) const {
    const auto begin = std::max(static_cast<std::int32_t>(range.begin), box_.firstColumn);
    const auto end = std::min(static_cast<std::int32_t>(range.end), box_.firstColumn + box_.columns);
    for (std::int32_t row = 0; row < box_.rows; ++row)
      for (std::int32_t column = begin; column < end; ++column) {
        const std::int32_t point = (box_.firstRow + row) * grid.stride + column;
        const std::int32_t here = row * box_.columns + column - box_.firstColumn;
        visit(static_cast<std::size_t>(point), sums_[static_cast<std::size_t>(here)]);
      }
  }

 private:
  PointBox box_;
  std::vector<T> sums_;
};

}  // namespace bedmix
