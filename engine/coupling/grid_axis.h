// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace bedmix {

/// Finds cells along one axis of a non-uniform grid in constant time: equal bins no wider than the smallest
/// cell point at the cell their left end lies in.
class GridAxis {
 public:
  /// Two neighbours and the share of the first; the second has the rest.
  struct Pair {
    int first = 0;
    int second = 0;
    double share = 1.0;
  };

  explicit GridAxis(const std::vector<double>& faces);

  /// The cell that holds `at`; the first or the last one outside the grid.
  int cellAt(double at) const;
  /// The cells under [at - radius, at + radius], by overlap. No cell may be smaller than 2 radius; what lies
  /// outside the grid counts to the outermost cell.
  Pair overlap(double at, double radius) const;
  /// Linear interpolation at one place: between the faces around it, and between the cell centres around it
  /// (constant beyond the outermost centres).
  struct Interpolation {
    Pair faces, centres;
  };
  Interpolation interpolate(double at) const;

 private:
  std::vector<double> faces_;
  std::vector<double> centres_;
  std::vector<double> perSize_;     // 1 / size of each cell
  std::vector<double> perSpacing_;  // 1 / distance of each centre to the next
  std::vector<int> cellOfBin_;
  double binsPerLength_ = 1.0;
};

}  // namespace bedmix
