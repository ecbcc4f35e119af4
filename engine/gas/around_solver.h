// SPDX-License-Identifier: MIT
#pragma once

#include "engine/gas/face_layout.h"
#include "engine/gas/member.h"
#include "engine/gas/multigrid.h"

#include <array>
#include <vector>

namespace bedmix {

/// The pressure system (see PressureSolver) between periodic sides, by conjugate gradients. The multigrid
/// knows no seam, so the bed is cut open at two places, half a width apart, and each cut bed preconditions
/// with what it is given by weights that fade to zero at its cut: M^-1 = sum over cuts of W M_cut^-1 W, with
/// sin^2 + cos^2 = 1 for the squares of the weights. All members call its functions together.
class AroundSolver {
 public:
  AroundSolver(const FaceLayout& layout, int members);

  /// Takes new conductances, one a face, that stay where they are until solve(). False where they are not
  /// finite, or nothing conducts.
  [[nodiscard]] bool prepare(Member& member, const std::vector<double>& conductance);
  /// Solves for b, a frame; writes p, until no cell's residual is larger than `relative` of the largest b, or
  /// than `absolute`. Returns the number of iterations, or -1 where more than `most` were needed.
  int solve(Member& member, const std::vector<double>& b, std::vector<double>& p, double relative,
            double absolute, int most);

 private:
  /// The bed from one column around to the one before it.
  struct Cut {
    int first;                        // column
    FaceLayout layout;                // sizes and what is solved, of a bed with walls
    std::vector<double> conductance;  // of its faces
    std::vector<float> weight;        // of its columns
    Multigrid multigrid;
    Cut(const FaceLayout& around, int firstColumn, int members);
  };
  static FaceLayout cutOpen(const FaceLayout& around, int firstColumn);
  /// What is known of faces in these rows, in the numbering of a cut.
  static void take(const FaceLayout& around, const std::vector<double>& faces, int firstColumn,
                   const FaceLayout& cut, Range rows, std::vector<double>& to);
  void precondition(Member& member);
  template <class OfPlace>
  double sum(Member& member, OfPlace&& ofPlace);
  template <class Visit>
  void forMine(const Member& member, Visit&& visit) const;

  const FaceLayout& layout_;
  const std::vector<double>* conductance_ = nullptr;
  std::array<Cut, 2> cuts_;
  std::vector<double> residual_, direction_, image_, z_;  // frames
  RowReduction<double> reduction_;
};

}  // namespace bedmix
