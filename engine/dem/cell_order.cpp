// SPDX-License-Identifier: MIT
#include "engine/dem/cell_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bedmix {

bool CellOrder::sort(const std::vector<Body>& bodies) {
  const auto n = static_cast<std::int32_t>(bodies.size());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec2 lowest{infinity, infinity}, highest{-infinity, -infinity};
  double finite = 0.0;  // 0, or not a number
  for (const Body& body : bodies) {
    const Vec2 p = body.position;
    lowest = {std::min(lowest.x, p.x), std::min(lowest.y, p.y)};
    highest = {std::max(highest.x, p.x), std::max(highest.y, p.y)};
    finite += p.x * 0.0 + p.y * 0.0;
  }
  if (finite != 0.0) return false;

  const double perSize = 1.0 / size_;
  const auto cells = [&](double length, std::int32_t most) {
    return static_cast<std::int32_t>(std::min(length * perSize, most - 1.0)) + 1;
  };
  const Vec2 box = highest - lowest;
  const bool repeats = period_ > 0.0, upright = repeats || box.x >= box.y;  // strips
  const auto most = [n](std::int32_t other) { return 8 * (n / other + 1); };
  perStrip_ = n == 0 ? 1 : cells(upright ? box.y : box.x, most(1));
  strips_ = n == 0 ? 1 : cells(upright ? box.x : box.y, most(perStrip_));
  double perWidth = perSize;  // of a strip
  if (repeats) {
    strips_ =
        static_cast<std::int32_t>(std::clamp(std::floor(period_ * perSize), 3.0, most(perStrip_) + 0.0));
    perWidth = static_cast<double>(strips_) / period_;
    lowest.x = 0.0;
  }

  // Counting sort: stable.
  cellOf_.resize(bodies.size());
  order_.resize(bodies.size());
  start_.assign(static_cast<std::size_t>(strips_) * perStrip_ + 1, 0);
  for (std::int32_t i = 0; i < n; ++i) {
    const double across =
        (upright ? bodies[i].position.x - lowest.x : bodies[i].position.y - lowest.y) * perWidth;
    const double along =
        (upright ? bodies[i].position.y - lowest.y : bodies[i].position.x - lowest.x) * perSize;
    const auto strip = static_cast<std::int32_t>(std::min(across, strips_ - 1.0));
    const auto place = static_cast<std::int32_t>(std::min(along, perStrip_ - 1.0));
    cellOf_[i] = strip * perStrip_ + place;
    ++start_[cellOf_[i]];
  }
  std::int32_t end = 0;
  for (std::int32_t& s : start_) s = end += s;
  for (std::int32_t i = n - 1; i >= 0; --i) order_[--start_[cellOf_[i]]] = i;
  // From here on by the new order.
  for (std::int32_t c = 0; c < strips_ * perStrip_; ++c)
    std::fill(cellOf_.begin() + start_[c], cellOf_.begin() + start_[c + 1], c);
  return true;
}

}  // namespace bedmix
