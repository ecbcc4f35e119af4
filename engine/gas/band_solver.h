// SPDX-License-Identifier: MIT
#pragma once

#include "engine/gas/face_layout.h"

#include <cstddef>
#include <vector>

namespace bedmix {

/// Factorizes the pressure system (see PressureSolver), A = U^T D^-1 U with the upper triangle U stored row
/// by row as a band: cells are numbered along the grid's short side first, whose length is the band's width.
/// Blocked cells stay in as equations of their own. Costs cells x width^2.
class BandSolver {
 public:
  explicit BandSolver(const FaceLayout& layout);

  /// False where the matrix is not positive definite or not finite.
  [[nodiscard]] bool prepare(const std::vector<double>& coefficient);
  void solve(const std::vector<double>& b, std::vector<double>& p);

 private:
  std::size_t unknown(int i, int j) const {
    return static_cast<std::size_t>(i) * columnStep_ + static_cast<std::size_t>(j) * rowStep_;
  }

  const FaceLayout& layout_;
  std::size_t cells_, columnStep_, rowStep_, width_;
  std::size_t rowLength_;         // in the band's memory
  std::vector<double> band_;      // rows of U: diagonal first
  std::vector<double> perPivot_;  // 1 / diagonal of U
  std::vector<double> x_;         // in the order of the unknowns
};

}  // namespace bedmix
