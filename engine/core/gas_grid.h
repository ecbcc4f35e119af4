// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bedmix {

/// Cells of the gas: rectilinear, non-uniform, the distributor a stair of blocked cells. Geometry only; built
/// from the scene, shared by the solver, the statistics and the pictures.
struct GasGrid {
  int columns = 0;
  int rows = 0;
  std::vector<double> x;       // columns + 1 faces, m
  std::vector<double> y;       // rows + 1 faces, m
  std::vector<int> lowestRow;  // per column: rows below are blocked
  std::vector<double>
      inletFlux;           // per column: superficial velocity through its floor, m/s (mean over the column)
  double thickness = 0.0;  // m
  bool repeats = false;    // sides are periodic: the last column is the first one's neighbour
  /// Per cell, where there are obstacles, else empty: of an open cell itself, of a blocked one the nearest
  /// open cell.
  std::vector<std::int32_t> openCell;
  /// Per cell, where there are obstacles, else empty: what is free, m3, in it and in the blocked cells that
  /// it stands for.
  std::vector<double> freeVolume;

  std::size_t cells() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  bool open(int column, int row) const {
    if (row < lowestRow[static_cast<std::size_t>(column)]) return false;
    return openCell.empty() || openCell[cell(column, row)] == static_cast<std::int32_t>(cell(column, row));
  }
  /// Whose values a blocked cell has: with obstacles the nearest open one's, else the one's above it.
  std::size_t openCellFor(int column, int row) const {
    if (openCell.empty()) return cell(column, std::max(row, lowestRow[static_cast<std::size_t>(column)]));
    return static_cast<std::size_t>(openCell[cell(column, row)]);
  }
  /// The column that stands here where sides are periodic.
  int columnAround(int column) const { return (column + columns) % columns; }
  double dx(int column) const {
    return x[static_cast<std::size_t>(column) + 1] - x[static_cast<std::size_t>(column)];
  }
  double dy(int row) const { return y[static_cast<std::size_t>(row) + 1] - y[static_cast<std::size_t>(row)]; }
  double volume(int column, int row) const { return dx(column) * dy(row) * thickness; }
  /// That particles can be in whose share of the voidage is the cell's, m3.
  double roomOf(int column, int row) const {
    return freeVolume.empty() ? volume(column, row) : freeVolume[cell(column, row)];
  }
};

/// The scene must have gas. Obstacles block cells whose centre lies in a circle, or that a segment with a
/// thickness goes through, and cells from which there is no way to the top. What enters below a blocked cell
/// on the floor is left out; a sound scene has none. A column is blocked up to the row face nearest to the
/// distributor at the column's centre, which turns 18 deg under columns and rows of 12 mm into
/// 0-0-1-1-1-2-2-2.
GasGrid makeGasGrid(const Scene& scene);

}  // namespace bedmix
