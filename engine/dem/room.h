// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/core/walls.h"
#include "engine/dem/wall_shape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace bedmix {

/// What obstacles leave of the bed for particles to be put into.
class Room {
 public:
  explicit Room(const Scene& scene) : obstacles_(wallShapes(obstacleWalls(scene))) {
    for (std::size_t o = 0; o < obstacles_.size(); ++o)
      if (scene.obstacles[o].shape == ObstacleShape::drum) {
        drum_ = obstacles_[o];
        obstacles_.erase(obstacles_.begin() + static_cast<std::ptrdiff_t>(o));
        break;
      }
  }

  bool isAll() const { return obstacles_.empty() && !drum_; }
  const std::optional<WallShape>& drum() const { return drum_; }
  /// Whether nothing comes nearer than `reach` (m) to the point.
  bool isFree(Vec2 at, double reach) const {
    if (drum_ && std::sqrt(drum_->distance2(at)) + reach > drum_->radius) return false;
    return std::all_of(obstacles_.begin(), obstacles_.end(),
                       [&](const WallShape& o) { return std::sqrt(o.distance2(at)) > o.radius + reach; });
  }

 private:
  std::vector<WallShape> obstacles_;
  std::optional<WallShape> drum_;
};

}  // namespace bedmix
