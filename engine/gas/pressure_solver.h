// SPDX-License-Identifier: MIT
#pragma once

#include "engine/gas/around_solver.h"
#include "engine/gas/band_solver.h"
#include "engine/gas/face_layout.h"
#include "engine/gas/member.h"
#include "engine/gas/multigrid.h"
#include "engine/gas/sparse_solver.h"

#include <optional>
#include <vector>

namespace bedmix {

/// The symmetric positive definite system of the pressure correction: for each open cell
///   sum over its solved faces of c_face (p_cell - p_other) = b_cell,
/// p = 0 beyond the outlet. Where that is cheaper the matrix is factorized as a band; else conjugate
/// gradients with a multigrid preconditioner. All members call its functions together.
class PressureSolver {
 public:
  /// For so many members at most.
  PressureSolver(const FaceLayout& layout, int members);

  /// Takes new conductances, one a face, m3/(s Pa), 0 where nothing is solved. False if one is not finite or
  /// the matrix is not positive definite.
  [[nodiscard]] bool prepare(Member& member, const std::vector<double>& conductance);
  /// When iterations end: no cell's residual is larger than this share of the largest b, or than `absolute`.
  struct Tolerance {
    double relative, absolute;
  };
  /// Solves for b, a frame that is 0 outside open cells; writes p. Returns the number of iterations, 0 where
  /// it was direct. What does not converge within `mostIterations` is solved directly after all.
  static constexpr int mostIterations = 200;
  int solve(Member& member, const std::vector<double>& b, std::vector<double>& p, Tolerance tolerance);

 private:
  struct Iteration {
    Multigrid multigrid;
    SparseSolver lastResort;
    std::vector<double> residual, direction, image;
    Iteration(const FaceLayout& layout, int members);
  };
  /// Between periodic sides.
  struct Around {
    AroundSolver solver;
    SparseSolver lastResort;
    Around(const FaceLayout& layout, int members) : solver(layout, members), lastResort(layout) {}
  };
  int iterate(Member& member, const std::vector<double>& b, std::vector<double>& p, Tolerance tolerance);
  int goAround(Member& member, const std::vector<double>& b, std::vector<double>& p, Tolerance tolerance);
  /// Over all rows, of what `ofRow` makes of a row's places.
  template <class OfRow>
  double sum(Member& member, OfRow&& ofRow);
  double largest(Member& member, double mine);

  const FaceLayout& layout_;
  const std::vector<double>* conductance_ = nullptr;
  std::optional<BandSolver> band_;      // one of
  std::optional<Iteration> iteration_;  // these three
  std::optional<Around> around_;
  bool sound_ = true;  // what the first member found out
  RowReduction<double> reduction_;
};

}  // namespace bedmix
