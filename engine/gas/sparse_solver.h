// SPDX-License-Identifier: MIT
#pragma once

#include "engine/gas/face_layout.h"

#include <memory>
#include <vector>

namespace bedmix {

/// Factorizes the pressure system (see PressureSolver) as it is, sparse, A = L D L^T with Eigen. Slower than
/// the band of a narrow grid and than the iteration of a wide one, but bound to end: for what does not
/// converge.
class SparseSolver {
 public:
  explicit SparseSolver(const FaceLayout& layout);
  ~SparseSolver();

  /// Solves for conductances, one a face, and b, a frame; writes p. False, and p is left alone, where the
  /// matrix is not positive definite.
  bool solve(const std::vector<double>& conductance, const std::vector<double>& b, std::vector<double>& p);

 private:
  struct Matrix;
  const FaceLayout& layout_;
  std::unique_ptr<Matrix> matrix_;
};

}  // namespace bedmix
