// SPDX-License-Identifier: MIT
#pragma once

#include "engine/gas/face_layout.h"
#include "engine/gas/member.h"

#include <cstddef>
#include <vector>

namespace bedmix {

/// One V-cycle of geometric multigrid for the pressure system (see PressureSolver): the preconditioner that
/// keeps the number of conjugate-gradient iterations independent of the grid's size. In single precision,
/// which a preconditioner may be. Cells are joined two by two, in a direction only while its coupling is not
/// much weaker than the other's; a coarse face conducts what its fine faces do together, in proportion to the
/// distances across it. Corrections are interpolated linearly from the coarse cell and its nearer neighbour
/// in each direction (Kwak 1999, SIAM J. Sci. Comput. 21:552); residuals go the same way back. Two Jacobi
/// sweeps before and after, damped so that together they are the Chebyshev polynomial for the upper part of
/// the spectrum, keep the cycle symmetric.
class Multigrid {
 public:
  explicit Multigrid(const FaceLayout& layout);

  /// Takes new coefficients, one a face, 0 where nothing is solved.
  void prepare(Member& member, const std::vector<double>& coefficient);
  /// Fields of the finest grid, framed like those of the layout: the right-hand side, to be filled in by each
  /// member for its rows, and what cycle() makes of it.
  float* rightHandSide() { return levels_.front().b.data(); }
  const float* solution() const { return levels_.front().x.data(); }
  /// Members see all of the solution after it.
  void cycle(Member& member) { cycle(member, 0); }

 private:
  /// Cells in one direction, and how they came from those of the level before. Entry i of what belongs to a
  /// face is that between i - 1 and i.
  struct Axis {
    std::vector<double> size;  // m
    bool joined = false;
    std::vector<double> conduction;  // per face, over that of the fine one
    std::vector<float> back, forth;  // share of the neighbour before in a cell's first, behind in its last

    int cells() const { return static_cast<int>(size.size()); }
    double sumOfSizes() const;
    double sumOfCouplings() const;
    Axis coarser(bool join) const;
  };

  struct Level {
    Axis across, up;
    int columns, rows, stride;
    std::vector<float> west, south;  // coupling to the cell at the left, below; zero pressure above the top
    std::vector<float> perDiagonal;  // 0 in blocked cells
    std::vector<float> x, other, b;  // `other` takes turns with x
    std::vector<float> toWest, toEast, toSouth, toNorth;  // shares in the interpolation to the finer level

    Level(Axis a, Axis u);
    int at(int column, int row) const { return (row + 1) * stride + column; }
    Range places(const Member& member) const;
    void updateDiagonal(Range places);
    void smooth(const std::vector<float>& from, std::vector<float>& to, float damping, Range places) const;
    void residual(const std::vector<float>& from, std::vector<float>& to, Range places) const;
  };
  void coarsen(const Level& fine, Level& coarse, Range rows) const;
  void restrict(const Level& fine, const std::vector<float>& residual, Level& coarse, Range rows) const;
  void prolong(const Level& coarse, Level& fine, Range rows) const;
  void prepareBelow(Member& member, std::size_t level);
  void cycle(Member& member, std::size_t level);

  std::vector<Level> levels_;  // finest first
};

}  // namespace bedmix
