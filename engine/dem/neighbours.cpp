// SPDX-License-Identifier: MIT
#include "engine/dem/neighbours.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr double skinOverDiameter = 0.3;  // measured: 0.2 to 0.4 cost the same within noise
constexpr double leastRemainder = 0.125;  // of the skin; with less left a new list is cheaper than measuring

}  // namespace

/// Square cells over the box that holds the particles. Their number is at most about eight a particle;
/// whoever lies beyond is counted into the last row or column, which moves no two neighbours further apart.
struct NeighbourList::CellGrid {
  double left, bottom, size;
  std::int32_t columns, rows;

  std::int32_t column(double x) const { return index(x - left, columns); }
  std::int32_t row(double y) const { return index(y - bottom, rows); }

 private:
  std::int32_t index(double distance, std::int32_t count) const {
    return static_cast<std::int32_t>(std::clamp(distance / size, 0.0, static_cast<double>(count - 1)));
  }
};

NeighbourList::NeighbourList(double diameter, const std::vector<WallSegment>& walls)
    : diameter_(diameter), skin_(skinOverDiameter * diameter), walls_(wallShapes(walls)) {}

void NeighbourList::build(const std::vector<double>& x, const std::vector<double>& y) {
  pairs_.swap(oldPairs_);
  wallPairs_.swap(oldWallPairs_);
  pairs_.clear();
  wallPairs_.clear();
  if (!x.empty()) {
    findPairs(x, y);
    findWallPairs(x, y);
  }
  builtX_ = x;
  builtY_ = y;
  spent_ = 0.0;
  ++builds_;
}

bool NeighbourList::measure(const std::vector<double>& x, const std::vector<double>& y) {
  double largest = 0.0, second = 0.0;  // squares
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = x[i] - builtX_[i], dy = y[i] - builtY_[i];
    const double d2 = dx * dx + dy * dy;
    if (d2 <= second) continue;
    second = std::min(largest, d2);
    largest = std::max(largest, d2);
  }
  spent_ = std::sqrt(largest) + std::sqrt(second);
  return spent_ <= (1.0 - leastRemainder) * skin_;
}

NeighbourList::CellGrid NeighbourList::fillCells(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<std::int32_t>(x.size());
  const auto [left, right] = std::minmax_element(x.begin(), x.end());
  const auto [bottom, top] = std::minmax_element(y.begin(), y.end());
  CellGrid grid{*left, *bottom, diameter_ + skin_, n, 8};
  grid.columns = grid.column(*right) + 1;
  grid.rows = 8 * (n / grid.columns + 1);
  grid.rows = grid.row(*top) + 1;

  // Counting sort: stable, hence ascending within a cell.
  cellOf_.resize(x.size());
  sorted_.resize(x.size());
  cellStart_.assign(static_cast<std::size_t>(grid.columns) * grid.rows + 1, 0);
  for (std::int32_t i = 0; i < n; ++i) {
    cellOf_[i] = grid.row(y[i]) * grid.columns + grid.column(x[i]);
    ++cellStart_[cellOf_[i]];
  }
  std::int32_t end = 0;
  for (std::int32_t& start : cellStart_) start = end += start;
  for (std::int32_t i = n - 1; i >= 0; --i) sorted_[--cellStart_[cellOf_[i]]] = i;
  return grid;
}

void NeighbourList::findPairs(const std::vector<double>& x, const std::vector<double>& y) {
  const CellGrid grid = fillCells(x, y);
  const double reach2 = grid.size * grid.size;
  const auto n = static_cast<std::int32_t>(x.size());
  for (std::int32_t i = 0; i < n; ++i) {
    const std::int32_t row = cellOf_[i] / grid.columns, column = cellOf_[i] % grid.columns;
    const std::int32_t fromColumn = std::max(column - 1, 0);
    const std::int32_t toColumn = std::min(column + 1, grid.columns - 1);
    const std::size_t firstOfI = pairs_.size();
    for (std::int32_t r = std::max(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r) {
      const std::int32_t begin = cellStart_[r * grid.columns + fromColumn];
      const std::int32_t end = cellStart_[r * grid.columns + toColumn + 1];
      for (std::int32_t s = begin; s < end; ++s) {
        const std::int32_t j = sorted_[s];
        const double dx = x[j] - x[i], dy = y[j] - y[i];
        if (!(j > i && dx * dx + dy * dy < reach2)) continue;
        // By insertion, as there are two or three.
        std::size_t place = pairs_.size();
        pairs_.push_back({i, j});
        for (; place > firstOfI && pairs_[place - 1].second > j; --place) pairs_[place] = pairs_[place - 1];
        pairs_[place] = {i, j};
      }
    }
  }
}

void NeighbourList::findWallPairs(const std::vector<double>& x, const std::vector<double>& y) {
  const double reach = diameter_ / 2.0 + skin_;
  const auto n = static_cast<std::int32_t>(x.size());
  for (std::int32_t i = 0; i < n; ++i)
    for (std::int32_t w = 0; w < static_cast<std::int32_t>(walls_.size()); ++w)
      if (walls_[w].distance2({x[i], y[i]}) < reach * reach) wallPairs_.push_back({i, w});
}

}  // namespace bedmix
