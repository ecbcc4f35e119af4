// SPDX-License-Identifier: MIT
#pragma once

#include "engine/gas/face_layout.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace bedmix {

/// One V-cycle of geometric multigrid for the pressure correction's system (see PressureSolver): the
/// preconditioner that keeps the number of conjugate-gradient iterations independent of the grid's size.
/// Cells are joined two by two, in a direction only while its coupling is not much weaker than the other's; a
/// coarse face conducts half of what its fine faces do together, for the distance across it is doubled
/// (Wesseling 1988, J. Comput. Phys. 79:85). Gauss-Seidel sweeps go forward before and backward after the
/// coarse correction, which keeps the cycle symmetric.
class Multigrid {
 public:
  Multigrid() = default;
  Multigrid(const FaceLayout& layout, const std::vector<int>& unknownOfCell);

  /// Takes new coefficients, one a volume of the layout, m3/(s Pa).
  void prepare(const FaceLayout& layout, const std::vector<double>& coefficient);
  /// Applies the cycle to a right-hand side over the unknowns; writes the approximate solution.
  void apply(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  /// Fields have a frame of one cell around them, whose couplings are zero.
  struct Level {
    int columns, rows, stride;
    bool joinColumns, joinRows;       // on the way to the next level
    std::vector<double> west, south;  // coupling to the cell at the left, below
    std::vector<double> outlet;       // coupling to zero pressure
    std::vector<double> perDiagonal;  // 0 in blocked cells
    std::vector<double> x, b, residual;

    Level(int c, int r);
    int at(int column, int row) const { return (row + 1) * stride + column + 1; }
    void updateDiagonal();
    void sweep(bool forward);
    void updateResidual();
  };
  void coarsen(const Level& fine, Level& coarse) const;
  void cycle(std::size_t level) const;

  std::vector<int> cellOfUnknown_;     // in the finest level's numbering
  mutable std::vector<Level> levels_;  // finest first; x, b, residual are scratch
};

}  // namespace bedmix
