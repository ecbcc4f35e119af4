// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/vec2.h"

namespace bedmix {

/// Sum over a particle's contacts; one row, which a contact adds to in one go.
struct alignas(32) Load {
  Vec2 force;           // N
  double torque = 0.0;  // N m, 0 without friction
  double unused = 0.0;

  Load& operator+=(const Load& o) { return force += o.force, torque += o.torque, *this; }
};

}  // namespace bedmix
