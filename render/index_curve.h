// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/mixing.h"

#include <cstddef>
#include <vector>

namespace bedmix {

/// A run's mixing indices up to now, for a curve that grows with the film. Memory is bounded: a long run
/// keeps every second, fourth, ... of its samples.
class IndexCurve {
 public:
  struct Point {
    float time = 0.0f;                  // s
    float lacey = 0.0f, ashton = 0.0f;  // NaN where undefined
  };

  /// Samples in order of time; one not later than the last is left out.
  void observe(const MixingSample& sample);
  const std::vector<Point>& points() const { return points_; }

  static constexpr std::size_t mostPoints = 4096;

 private:
  std::vector<Point> points_;
  std::size_t stride_ = 1, seen_ = 0;  // of all samples, each stride-th is kept
  double last_ = -1.0;                 // s
};

}  // namespace bedmix
