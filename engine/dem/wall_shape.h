// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/vec2.h"
#include "engine/core/walls.h"

#include <vector>

namespace bedmix {

/// A wall as a particle meets it: a face and, at the ends it owns, corners. A corner pushes only what lies
/// beyond the ends of both walls that meet there, so a particle before an outer corner is pushed once.
struct WallShape {
  Vec2 a, b;            // m
  Vec2 along;           // unit vector from a to b
  double length = 0.0;  // m
  bool ownsA = true;
  bool ownsB = true;
  Vec2 awayA, awayB;  // unit vectors from each end along the wall that adjoins there; this wall's own if none

  /// Finds the point that pushes a particle at `p`; false where this wall does not.
  bool touchPoint(Vec2 p, Vec2& point) const {
    const double t = dot(p - a, along);
    if (t < 0.0) {
      point = a;
      return ownsA && dot(p - a, awayA) < 0.0;
    }
    if (t > length) {
      point = b;
      return ownsB && dot(p - b, awayB) < 0.0;
    }
    point = a + t * along;
    return true;
  }

  /// Square of the distance between `p` and the segment, m2.
  double distance2(Vec2 p) const {
    const double t = dot(p - a, along);
    const Vec2 r = p - (a + (t < 0.0 ? 0.0 : t > length ? length : t) * along);
    return dot(r, r);
  }
};

/// Segments adjoin where they share an end point to the bit. None may have zero length.
std::vector<WallShape> wallShapes(const std::vector<WallSegment>& segments);

}  // namespace bedmix
