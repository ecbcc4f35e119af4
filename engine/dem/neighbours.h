// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/wall_shape.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bedmix {

/// Two that may touch before the list is built anew: particles `first` < `second`, or a particle and a wall.
struct Candidate {
  std::int32_t first, second;
  friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

/// Verlet's list: every pair closer than a diameter plus a skin, and every particle that close to a wall,
/// each once and in ascending order, so that sums over it never depend on when it was built. It holds while
/// the two largest displacements since then add up to less than the skin.
class NeighbourList {
 public:
  NeighbourList(double diameter, const std::vector<WallSegment>& walls);

  /// Builds the list anew; coordinates in m, finite. Cost grows linearly with their number.
  void build(const std::vector<double>& x, const std::vector<double>& y);

  /// Every particle has moved by at most `distance`, m, since the last call or measurement. False when the
  /// skin may be used up: the sum of 2 v_max dt after Tian et al. (2007), Eq. (11).
  bool spend(double distance) { return (spent_ += 2.0 * distance) <= skin_; }
  /// Whether a move of `distance`, m, could be spent.
  bool covers(double distance) const { return spent_ + 2.0 * distance <= skin_; }
  /// Replaces what was spent by the two largest displacements there really are. False when too little is
  /// left to go on with.
  bool measure(const std::vector<double>& x, const std::vector<double>& y);

  const std::vector<Candidate>& pairs() const { return pairs_; }
  const std::vector<Candidate>& wallPairs() const { return wallPairs_; }
  std::size_t size() const { return pairs_.size() + wallPairs_.size(); }
  /// The lists before the last build, for what is to be carried over.
  const std::vector<Candidate>& oldPairs() const { return oldPairs_; }
  const std::vector<Candidate>& oldWallPairs() const { return oldWallPairs_; }

  const std::vector<WallShape>& walls() const { return walls_; }
  std::int64_t builds() const { return builds_; }

 private:
  struct CellGrid;
  CellGrid fillCells(const std::vector<double>& x, const std::vector<double>& y);
  void findPairs(const std::vector<double>& x, const std::vector<double>& y);
  void findWallPairs(const std::vector<double>& x, const std::vector<double>& y);

  double diameter_;
  double skin_;
  double spent_ = 0.0;
  std::int64_t builds_ = 0;
  std::vector<WallShape> walls_;
  std::vector<Candidate> pairs_, oldPairs_;
  std::vector<Candidate> wallPairs_, oldWallPairs_;
  std::vector<double> builtX_, builtY_;  // where the particles were at the last build
  std::vector<std::int32_t> cellOf_;     // of each particle
  std::vector<std::int32_t> cellStart_;  // first entry of each cell in sorted_, and one past the last
  std::vector<std::int32_t> sorted_;     // particles by cell, ascending within one
};

}  // namespace bedmix
