// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/vec2.h"
#include "engine/core/walls.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bedmix {

/// A wall as a particle meets it: a face and, at the ends it owns, corners. A corner pushes only what lies
/// beyond the ends of both walls that meet there, so a particle before an outer corner is pushed once. With a
/// radius, its surface is so far from that; particles may be on either side of it.
struct WallShape {
  Vec2 a, b;            // m
  Vec2 along;           // unit vector from a to b
  double length = 0.0;  // m
  bool ownsA = true;
  bool ownsB = true;
  Vec2 awayA, awayB;  // unit vectors from each end along the wall that adjoins there; this wall's own if none
  double radius = 0.0;            // m
  double spin = 0.0;              // rad/s, of a circle's surface
  double amplitude = 0.0;         // m; moves by amplitude sin(angularFrequency t), upward
  double angularFrequency = 0.0;  // rad/s
  Vec2 velocity;                  // m/s, where it is

  static constexpr double tiny = 1e-300;  // m; stands for a distance of zero

  /// Straight, thin and at rest.
  bool isPlain() const { return radius == 0.0 && amplitude == 0.0; }
  bool moves() const { return amplitude != 0.0; }

  /// This wall at a time, s, of one as wallShapes() makes it.
  WallShape at(double time) const {
    WallShape now = *this;
    const double phase = angularFrequency * time;
    now.a.y += amplitude * std::sin(phase);
    now.b.y += amplitude * std::sin(phase);
    now.velocity.y = amplitude * angularFrequency * std::cos(phase);
    return now;
  }
  /// The largest speed with which it comes to meet a particle, m/s.
  double fastest() const { return amplitude * angularFrequency; }

  /// From the nearest point of the segment to that of the surface.
  Vec2 onSurface(Vec2 p, Vec2 core) const {
    const Vec2 out = p - core;
    return core + (radius / std::max(norm(out), tiny)) * out;
  }

  /// Finds the point that pushes a particle at `p`; false where this wall does not.
  bool touchPoint(Vec2 p, Vec2& point) const {
    const bool pushes = corePoint(p, point);
    if (radius > 0.0) point = onSurface(p, point);
    return pushes;
  }

  /// The same of the segment.
  bool corePoint(Vec2 p, Vec2& point) const {
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

  /// Distance between `p` and the surface, m.
  double distance(Vec2 p) const { return std::abs(std::sqrt(distance2(p)) - radius); }

  /// Square of the distance between `p` and the segment, m2.
  double distance2(Vec2 p) const {
    const double t = dot(p - a, along);
    const Vec2 r = p - (a + (t < 0.0 ? 0.0 : t > length ? length : t) * along);
    return dot(r, r);
  }
};

/// Segments adjoin where they share an end point to the bit. None may have zero length but circles.
std::vector<WallShape> wallShapes(const std::vector<WallSegment>& segments);

}  // namespace bedmix
