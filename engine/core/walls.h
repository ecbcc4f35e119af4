// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/core/vec2.h"

#include <vector>

namespace bedmix {

/// A straight wall from `a` to `b` that particles touch from either side. Where two segments meet, the shared
/// end point belongs to one of them only, so that an outer corner pushes once.
struct WallSegment {
  Vec2 a, b;  // m
  bool ownsA = true;
  bool ownsB = true;
};

/// Left wall, floor (flat, incline or stair), right wall and, with `top = "lid"`, the lid. With an open top
/// the side walls go on far above anything a particle reaches.
std::vector<WallSegment> bedWalls(const Scene& scene);

}  // namespace bedmix
