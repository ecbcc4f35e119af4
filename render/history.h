// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "render/style.h"

#include <span>
#include <vector>

namespace bedmix {

/// What pictures need of earlier frames: where the particles started, and where chosen ones have been of
/// late. Its memory is bounded whatever the length of the run, and none for a style without such needs.
class History {
 public:
  struct Point {
    double time = 0.0;  // s
    Vec2f position;     // m
  };

  History() = default;
  explicit History(const Style& style);

  /// Takes note of a frame. The first one is the start. A frame that is not later than the last replaces
  /// what was seen from its time on.
  void observe(const Frame& frame);

  /// Positions in the first frame, m; empty where the style does not ask for them or nothing was seen.
  std::span<const Vec2f> start() const { return start_; }
  /// Places of the style's n-th particle, oldest first, not longer ago than its trail lasts; at most
  /// `mostPoints`, evenly in time, and the newest one.
  std::span<const Point> trail(std::size_t n) const { return trails_[n]; }
  std::size_t trails() const { return trails_.size(); }

  static constexpr std::size_t mostPoints = 200;

 private:
  std::vector<std::int64_t> ids_;
  double trailTime_ = 0.0;  // s
  bool keepsStart_ = false;
  std::vector<Vec2f> start_;
  std::vector<std::vector<Point>> trails_;
};

}  // namespace bedmix
