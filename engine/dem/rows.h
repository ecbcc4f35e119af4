// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/vec2.h"

// What contacts read of a particle and what they add to it, each a row that is loaded and stored in one go.

namespace bedmix {

/// Where a particle is and how fast, at the instant at which forces are evaluated.
struct alignas(32) Body {
  Vec2 position;  // m
  Vec2 velocity;  // m/s
};

/// Sum over a particle's contacts.
struct alignas(32) Load {
  Vec2 force;           // N
  double torque = 0.0;  // N m, 0 without friction
  double unused = 0.0;

  Load& operator+=(const Load& o) { return force += o.force, torque += o.torque, *this; }
};

}  // namespace bedmix
