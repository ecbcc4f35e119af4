// SPDX-License-Identifier: MIT
#pragma once

#include "engine/gas/face_layout.h"

#include <cstddef>
#include <vector>

namespace bedmix {

/// Factorizes the pressure system (see PressureSolver), A = L D L^T, as a band: cells are numbered along the
/// grid's short side first, whose length is the band's width. Where sides are periodic columns are numbered
/// from both ends in turn, 0, n - 1, 1, n - 2, ..., so that neighbours are two apart at most. Blocked cells
/// stay in as equations of their own. Costs cells x width^2.
class BandSolver {
 public:
  explicit BandSolver(const FaceLayout& layout);

  /// Takes new conductances, one a face. False where the matrix is not positive definite or not finite.
  [[nodiscard]] bool prepare(const std::vector<double>& conductance);
  /// Solves for b, a frame; writes p.
  void solve(const std::vector<double>& b, std::vector<double>& p);

 private:
  template <bool around>
  std::size_t unknown(int i, int j) const {
    const auto column = static_cast<std::size_t>(i);
    return (around ? columnPlace_[column] : column) * columnStep_ + static_cast<std::size_t>(j) * rowStep_;
  }
  template <bool around>
  void fill(const std::vector<double>& conductance);
  template <bool around>
  void solveFor(const std::vector<double>& b, std::vector<double>& p);

  const FaceLayout& layout_;
  std::size_t columnStep_, rowStep_, width_;
  std::vector<std::size_t> columnPlace_;  // among columns, where sides are periodic
  std::size_t blocks_;                    // of four unknowns
  std::size_t rowLength_;         // of the band's rows, which begin with the column their block begins with
  std::vector<double> band_;      // rows of the upper triangle: of A, then of L^T
  std::vector<double> perPivot_;  // 1 / D
  std::vector<double> x_;         // in the order of the unknowns
  std::vector<double> scaled_;    // four rows
};

}  // namespace bedmix
