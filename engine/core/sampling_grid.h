// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/scene.h"

#include <algorithm>
#include <cstddef>

namespace bedmix {

/// Equal cells over the bed's width and height in which tracer is counted (Tian et al. 2007, Fig. 5);
/// row-major, bottom row first. A particle on an edge belongs to the cell to its right or above, on the
/// outermost edges to the last cell; one outside is in no cell.
struct SamplingGrid {
  int columns = 4;
  int rows = 15;
  int minParticles = 21;  // a cell with fewer is not used
  double width = 0.0;     // m
  double height = 0.0;    // m

  std::size_t cells() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  bool operator==(const SamplingGrid&) const = default;
};
SamplingGrid samplingGrid(const Scene& scene);

/// Index of the cell of n over [0, length] that holds `at`, or -1 outside.
inline int cellOf(float at, double length, int n) {
  const double scaled = static_cast<double>(at) / length * n;
  if (!(scaled >= 0.0 && scaled <= n)) return -1;
  return std::min(static_cast<int>(scaled), n - 1);
}

/// Calls `use(cell, row of the frame)` for each particle in the grid.
template <class Use>
void forParticlesInCells(const Frame& frame, const SamplingGrid& grid, const Use& use) {
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const int column = cellOf(frame.position[i].x, grid.width, grid.columns);
    const int row = cellOf(frame.position[i].y, grid.height, grid.rows);
    if (column >= 0 && row >= 0) use(static_cast<std::size_t>(row) * grid.columns + column, i);
  }
}

}  // namespace bedmix
