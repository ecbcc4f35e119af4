// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

namespace bedmix {

/// Finds cells along one axis of a non-uniform grid in constant time and without branches, which particles'
/// places would mispredict: equal bins no wider than the smallest cell point at the cell their left end lies
/// in.
class GridAxis {
 public:
  /// Two neighbours and the share of the first; the second has the rest.
  struct Pair {
    int first = 0;
    int second = 0;
    double share = 1.0;
  };
  /// Linear interpolation at one place: between the faces around it, and between the cell centres around it
  /// (constant beyond the outermost centres).
  struct Interpolation {
    Pair faces, centres;
  };

  explicit GridAxis(const std::vector<double>& faces);

  /// The cell that holds `at`; the first or the last one outside the grid.
  int cellAt(double at) const {
    const double bin = std::clamp(at * binsPerLength_, 0.0, lastBin_);
    int cell = cellOfBin_[static_cast<std::size_t>(bin)];
    // A bin no wider than a cell holds one face at most; rounding may have put `at` into the bin beside its
    // own.
    cell += static_cast<int>(at >= upper_[cell]);
    cell -= static_cast<int>(at < lower_[cell]);
    return cell;
  }

  /// The cells under [at - radius, at + radius], by overlap. No cell may be smaller than 2 radius; what lies
  /// outside the grid counts to the outermost cell.
  Pair overlap(double at, double radius) const {
    const int cell = cellAt(at - radius);
    const double inside = std::min(1.0, (upper_[cell] - (at - radius)) / (2.0 * radius));
    return {cell, next_[cell], next_[cell] == cell ? 1.0 : inside};
  }

  Interpolation interpolate(double at) const {
    const int cell = cellAt(at);
    const CentrePair& c = between_[cell + static_cast<int>(at >= centre_[cell])];
    return {{cell, cell + 1, std::clamp((faces_[cell + 1] - at) * perSize_[cell], 0.0, 1.0)},
            {c.first, c.second, (c.upper - at) * c.perSpacing + c.offset}};
  }

 private:
  /// Centres to either side of a gap between them: share of the first = (upper - at) * perSpacing + offset.
  /// Beyond the outermost centres perSpacing is 0 and offset 1.
  struct CentrePair {
    int first, second;
    double upper, perSpacing, offset;
  };

  std::vector<double> faces_, centre_, perSize_;
  std::vector<double> lower_, upper_;  // faces of each cell; the outermost are infinitely far
  std::vector<int> next_;              // the cell above; the last cell's is itself
  std::vector<CentrePair> between_;    // below the first centre, between each two, above the last
  std::vector<int> cellOfBin_;
  double binsPerLength_ = 1.0, lastBin_ = 0.0;
};

}  // namespace bedmix
