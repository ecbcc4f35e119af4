// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/core/vec2.h"

#include <vector>

namespace bedmix {

/// A straight wall from `a` to `b` that particles touch from either side. Where two segments meet, the shared
/// end point belongs to one of them only, so that an outer corner pushes once. With a radius the surface is
/// all that is so far from the segment: of a plate with round ends, or of a circle where b is a, which
/// particles touch from outside or inside.
struct WallSegment {
  Vec2 a, b;  // m
  bool ownsA = true;
  bool ownsB = true;
  double radius = 0.0;            // m
  double spin = 0.0;              // rad/s, of a circle's surface, counter-clockwise
  double amplitude = 0.0;         // m; it moves upward by amplitude sin(angularFrequency t)
  double angularFrequency = 0.0;  // rad/s
};

inline bool isCircle(const WallSegment& wall) { return wall.a == wall.b; }

/// Where it is at a time, s.
WallSegment wallAt(const WallSegment& wall, double time);
/// The point of its surface nearest to `p`.
Vec2 nearestOn(const WallSegment& wall, Vec2 p);

/// Left wall, floor (flat, incline or stair), right wall and, with `top = "lid"`, the lid. With an open top
/// the side walls go on far above anything a particle reaches; with periodic sides there are none.
std::vector<WallSegment> bedWalls(const Scene& scene);

/// What stands in the bed. An end that two segments share belongs to the first of them.
std::vector<WallSegment> obstacleWalls(const Scene& scene);

/// Whether particles are in a drum.
bool hasDrum(const Scene& scene);

/// All that particles meet. With periodic sides floor and lid go on beyond them, for particles that hang
/// over.
std::vector<WallSegment> allWalls(const Scene& scene);

}  // namespace bedmix
