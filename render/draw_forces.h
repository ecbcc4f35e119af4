// SPDX-License-Identifier: MIT
#pragma once

#include "render/draw_bed.h"

#include <vector>

namespace bedmix {

/// A contact of a frame: from the centre of one particle to that of another, or to a wall.
struct FrameContact {
  Vec2f from, to;      // m
  double force = 0.0;  // N, stiffness times overlap
};
/// The elastic normal force of every contact, from the frame's positions alone. These are floats, so an
/// overlap is known to some 6e-8 of the bed's size. In the order of the particles' places.
std::vector<FrameContact> contactsOf(const Frame& frame, const Scene& scene);

/// Appends a line a contact, as wide as its force is large; what would be thinner than a quarter of a pixel
/// is left out.
void drawForces(DrawList& list, const BedView& view);

/// Width of the line of a force, N; px, at most that of a particle.
float forceWidth(const Scene& scene, const Camera& camera, double force);

}  // namespace bedmix
