// SPDX-License-Identifier: MIT
#include "engine/dem/wall_shape.h"

namespace bedmix {

namespace {

/// Unit vector from `end` along another segment that ends there; `own` where there is none.
Vec2 awayFrom(Vec2 end, Vec2 own, std::size_t self, const std::vector<WallSegment>& segments) {
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const WallSegment& other = segments[s];
    if (s == self || isCircle(other)) continue;
    const Vec2 away = other.a == end ? other.b - end : other.a - end;
    if (other.a == end || other.b == end) return (1.0 / norm(away)) * away;
  }
  return own;
}

}  // namespace

std::vector<WallShape> wallShapes(const std::vector<WallSegment>& segments) {
  std::vector<WallShape> shapes;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const WallSegment& segment = segments[s];
    WallShape shape;
    shape.a = segment.a;
    shape.b = segment.b;
    shape.radius = segment.radius;
    shape.spin = segment.spin;
    shape.amplitude = segment.amplitude;
    shape.angularFrequency = segment.angularFrequency;
    if (isCircle(segment)) {
      shape.along = shape.awayA = {1.0, 0.0};
      shape.awayB = {-1.0, 0.0};
      shapes.push_back(shape);
      continue;
    }
    shape.length = norm(segment.b - segment.a);
    shape.along = (1.0 / shape.length) * (segment.b - segment.a);
    shape.ownsA = segment.ownsA;
    shape.ownsB = segment.ownsB;
    shape.awayA = awayFrom(segment.a, shape.along, s, segments);
    shape.awayB = awayFrom(segment.b, -1.0 * shape.along, s, segments);
    shapes.push_back(shape);
  }
  return shapes;
}

}  // namespace bedmix
