// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/thread_team.h"

#include <cstddef>
#include <vector>

namespace bedmix {

/// Cells in one direction of a multigrid level, and how they came from those of the finer one. Entry i of
/// what belongs to a face is that between i - 1 and i.
struct LevelAxis {
  std::vector<double> size;         // m
  bool joined = false;              // two by two
  std::vector<double> conductance;  // per face, over that of the fine one
  std::vector<float> back, forth;   // share of the neighbour before in a cell's first, behind in its last

  int cells() const { return static_cast<int>(size.size()); }
  double sumOfSizes() const;
  double sumOfCouplings() const;
  LevelAxis coarser(bool join) const;
};

/// A part of a grid.
struct Patch {
  Range rows, columns;
};

/// One grid of the multigrid cycle, framed as in FaceLayout. A coarse face conducts what its fine faces do
/// together, in proportion to the distances across it. Interpolation to the finer grid is linear, between a
/// cell and its nearer neighbour in each direction (Kwak 1999, SIAM J. Sci. Comput. 21:552).
struct GridLevel {
  LevelAxis across, up;
  int columns, rows, stride;
  std::vector<float> west, south;     // coupling to the cell at the left, below; zero pressure above the top
  std::vector<float> perDiagonal;     // 0 in blocked cells
  std::vector<float> b, smoothed, x;  // right-hand side; after descend(); after ascend()
  std::vector<float> toWest, toEast, toSouth, toNorth;  // the neighbours' shares in the finer grid's cells

  GridLevel(LevelAxis a, LevelAxis u);
  GridLevel coarser() const;

  int at(int column, int row) const { return (row + 1) * stride + column; }
  int cells() const { return columns * rows; }

  void updateDiagonal(Range rows);
  /// Takes from the finer grid what faces in these rows conduct; one row more than there are has the outlet.
  void conductLike(const GridLevel& fine, Range rows);
  /// Interpolates only from where cells are coupled.
  void updateShares();

  /// Room for the rows at hand in descend() and ascend(), floats a thread. What these need of other patches
  /// they compute again.
  std::size_t scratchSize() const { return 8 * (static_cast<std::size_t>(stride) + 4); }
  /// Smooths x = 0 twice and hands the residual down to `coarse`, for a patch of the latter.
  void descend(GridLevel& coarse, const Patch& patch, float* scratch);
  /// Adds the correction of `coarse` and smooths twice, for a patch of the latter.
  void ascend(const GridLevel& coarse, const Patch& patch, float* scratch);
};

}  // namespace bedmix
