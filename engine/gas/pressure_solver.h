// SPDX-License-Identifier: MIT
#pragma once

#include "engine/gas/face_layout.h"

#include <memory>
#include <vector>

namespace bedmix {

/// The symmetric positive definite system of the pressure correction: for each open cell
///   sum over its solved faces of c_face (p_cell - p_other) = b_cell,
/// p = 0 beyond the outlet. Small grids are factorized (sparse LDL^T, pattern analysed once), large ones
/// solved by conjugate gradients with a multigrid preconditioner.
class PressureSolver {
 public:
  explicit PressureSolver(const FaceLayout& layout);
  ~PressureSolver();

  /// Takes new coefficients, one a volume of the layout, m3/(s Pa). False if one is not finite or the matrix
  /// is not positive definite.
  [[nodiscard]] bool prepare(const std::vector<double>& coefficient);
  /// Solves for b given per cell (blocked cells ignored); writes p per cell, 0 in blocked cells.
  void solve(const std::vector<double>& b, std::vector<double>& p);
  /// Of the last solve; 0 where it was direct.
  int iterations() const;

 private:
  struct Matrix;
  std::unique_ptr<Matrix> matrix_;
};

}  // namespace bedmix
