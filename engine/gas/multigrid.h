// SPDX-License-Identifier: MIT
#pragma once

#include "engine/gas/face_layout.h"
#include "engine/gas/grid_level.h"
#include "engine/gas/member.h"

#include <cstddef>
#include <vector>

namespace bedmix {

/// One V-cycle of geometric multigrid for the pressure system (see PressureSolver): the preconditioner that
/// keeps the number of conjugate-gradient iterations independent of the grid's size. In single precision,
/// which a preconditioner may be. Cells are joined two by two, in a direction only while its coupling is not
/// much weaker than the other's.
class Multigrid {
 public:
  /// For so many members at most.
  Multigrid(const FaceLayout& layout, int members);

  /// Takes new conductances, one a face, 0 where nothing is solved.
  void prepare(Member& member, const std::vector<double>& conductance);
  /// Fields of the finest grid, framed like those of the layout: the right-hand side, to be filled in and
  /// waited for, and what cycle() makes of it.
  float* rightHandSide() { return levels_.front().b.data(); }
  const float* solution() const { return levels_.front().x.data(); }
  /// Members see all of the solution after it.
  void cycle(Member& member) {
    cycle(member, 0);
    member.wait();
  }

 private:
  void prepareFrom(Member& member, std::size_t level);
  void cycle(Member& member, std::size_t level);

  std::vector<GridLevel> levels_;            // finest first, one cell last
  std::vector<std::vector<float>> scratch_;  // per member
};

}  // namespace bedmix
