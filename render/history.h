// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "render/style.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace bedmix {

/// What pictures need of earlier frames: how the particles started, and where chosen ones have been of late.
/// Its memory is bounded whatever the length of the run, and none for a style without such needs.
class History {
 public:
  struct Point {
    double time = 0.0;  // s
    Vec2f position;     // m
  };

  History() = default;
  History(const Scene& scene, const Style& style);

  /// Takes note of a frame. The first one is the start. A frame that is not later than the last replaces
  /// what was seen from its time on.
  void observe(const Frame& frame);

  /// Class of a particle by its place in the first frame, from 0: the lowest or leftmost. None where it was
  /// not there or the style has no classes.
  std::optional<std::uint16_t> startClass(std::int32_t id) const;
  /// Places of the style's n-th particle, oldest first, not longer ago than its trail lasts; at most
  /// `mostPoints`, about evenly in time, and the newest one.
  std::span<const Point> trail(std::size_t n) const { return trails_[n]; }
  std::size_t trails() const { return trails_.size(); }

  static constexpr std::size_t mostPoints = 200;

 private:
  Style style_{Layers{}};
  double width_ = 0.0;                 // m, of the bed
  std::vector<std::int32_t> startId_;  // in order
  std::vector<std::uint16_t> startClass_;
  std::vector<std::vector<Point>> trails_;
};

}  // namespace bedmix
