// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/thread_team.h"
#include "engine/dem/rows.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bedmix {

/// Sorts particles into square cells, strip by strip across the short side of the box that holds them: who
/// are neighbours in space then are near each other in memory, and whoever may touch a particle stands in two
/// runs behind it, one in its own strip and one in the next. Cells are at most about eight a particle;
/// whoever lies beyond is counted into the last ones, which moves no two neighbours further apart.
///
/// Where places repeat sideways, strips are upright and fill the period; whoever stands in the first one then
/// has neighbours in a third run, in the last strip. A period holds three cells at least.
class CellOrder {
 public:
  /// `size` of the cells, m: no less than the distance within which neighbours are sought; and the period, m,
  /// or 0.
  explicit CellOrder(double size, double period = 0.0) : size_(size), period_(period) {}

  /// False, and nothing done, where a particle is at no finite place. Cost grows linearly with their number.
  bool sort(const std::vector<Body>& bodies);

  /// Who comes k-th, by their numbers before; in a cell as they stood.
  const std::vector<std::int32_t>& order() const { return order_; }

  /// Calls visit(k, sameStrip, nextStrip) for the particles `k` in `range` of the order, ascending, with the
  /// ranges of those behind it in the order that may be within reach, each pair of particles once.
  template <class Visit>
  void forNeighbours(Range range, Visit&& visit) const;
  /// The same where places repeat: visit(k, sameStrip, nextStrip, lastStrip).
  template <class Visit>
  void forNeighboursAround(Range range, Visit&& visit) const;

 private:
  double size_, period_;
  std::int32_t strips_ = 0, perStrip_ = 0;
  std::vector<std::int32_t> cellOf_, order_;
  std::vector<std::int32_t> start_;  // of each cell in the order, and one past the last
};

template <class Visit>
void CellOrder::forNeighbours(Range range, Visit&& visit) const {
  for (std::size_t k = range.begin; k < range.end;) {
    const std::int32_t cell = cellOf_[k], strip = cell / perStrip_, place = cell % perStrip_;
    const std::int32_t above = place + 1 < perStrip_ ? 1 : 0, below = place > 0 ? 1 : 0;
    const auto cellEnd = static_cast<std::size_t>(start_[cell + 1]);
    const auto sameEnd = static_cast<std::size_t>(start_[cell + 1 + above]);
    Range next{0, 0};
    if (strip + 1 < strips_)
      next = {static_cast<std::size_t>(start_[cell + perStrip_ - below]),
              static_cast<std::size_t>(start_[cell + perStrip_ + above + 1])};
    for (; k < std::min(cellEnd, range.end); ++k) visit(k, Range{k + 1, sameEnd}, next);
  }
}

template <class Visit>
void CellOrder::forNeighboursAround(Range range, Visit&& visit) const {
  forNeighbours(range, [&](std::size_t k, Range same, Range next) {
    const std::int32_t cell = cellOf_[k], place = cell % perStrip_;
    Range last{0, 0};
    if (cell < perStrip_) {
      const std::int32_t other = (strips_ - 1) * perStrip_ + place;
      last = {static_cast<std::size_t>(start_[place > 0 ? other - 1 : other]),
              static_cast<std::size_t>(start_[place + 1 < perStrip_ ? other + 2 : other + 1])};
    }
    visit(k, same, next, last);
  });
}

}  // namespace bedmix
