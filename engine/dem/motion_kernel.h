// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/thread_team.h"
#include "engine/core/vec2.h"
#include "engine/dem/rows.h"

namespace bedmix {

/// A step over particles, in vectors; one value a particle: the velocity gains the force times `early`, the
/// position the velocity times `step`, the velocity the new force times `late`. Half a step each are velocity
/// Verlet, a whole step and none symplectic Euler. Without friction what turns is null, without external
/// forces these are.
struct MotionKernel {
  double step = 0.0;         // s
  double early = 0.0;        // s
  double late = 0.0;         // s
  double gravity = 0.0;      // m/s2, downward
  double perMass = 0.0;      // 1/kg
  double perInertia = 0.0;   // 1/(kg m2)
  Body* body = nullptr;      // drifts; its velocity is predicted to the end of the step
  Vec2* position = nullptr;  // of the body, after a last kick
  Vec2* velocity = nullptr;
  double* spin = nullptr;
  const Vec2* external = nullptr;  // N, on a particle at rest
  const double* drag = nullptr;    // kg/s
  Load* loads = nullptr;           // of contacts; zero after a drift
  double* spinAhead = nullptr;     // predicted likewise

  /// The early part of a step in velocity, all of it in position. The drag of the step is that of the
  /// velocity with which the position moves, implicitly: v' = (v + early a) / (1 + early drag/m), and its
  /// impulse exactly -drag times the displacement. Returns the square of the largest of these speeds;
  /// infinite where one is not finite.
  double drift(Range particles) const;
  /// The late part of a step, the last of several. Returns the like of the speeds after it.
  double kick(Range particles) const;
  /// The late part of a step and the early one of the next. Returns as drift() does.
  double kickAndDrift(Range particles) const;
};

}  // namespace bedmix
