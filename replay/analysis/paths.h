// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/period.h"
#include "replay/analysis/by_id.h"

#include <vector>

namespace bedmix {

/// Where particles have come to, from frame to frame the shorter way: with periodic sides those that go
/// around and around get ever further, and do not come back.
class Paths {
 public:
  explicit Paths(const Scene& scene) : period_(scene) {}

  /// By rows of the frame; valid as long as that, and until the next.
  const std::vector<Vec2f>& follow(const Frame& frame) {
    if (!period_.isOn()) return frame.position;
    std::vector<Vec2f> now = frame.position;
    forParticlesInBoth(id_, frame.id,
                       [&](std::size_t i, std::size_t j) { now[j] = period_.next(position_[i], now[j]); });
    position_ = std::move(now);
    id_ = frame.id;
    return position_;
  }

 private:
  Period period_;
  std::vector<std::int32_t> id_;
  std::vector<Vec2f> position_;
};

}  // namespace bedmix
