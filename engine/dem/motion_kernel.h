// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/thread_team.h"
#include "engine/core/vec2.h"
#include "engine/dem/rows.h"

namespace bedmix {

/// Steps over particles, in vectors; one value a particle. Without friction what turns is null, without
/// external forces these are.
struct MotionKernel {
  double step = 0.0;               // s
  bool halves = true;              // velocity Verlet; else symplectic Euler
  double gravity = 0.0;            // m/s2, downward
  double perMass = 0.0;            // 1/kg, of all
  double perInertia = 0.0;         // 1/(kg m2)
  const double* masses = nullptr;  // kg, where they are not alike; else null
  const double* radii = nullptr;   // m, likewise: of spheres of these masses that turn as the particles do
  Body* body = nullptr;            // drifts; its velocity is predicted to the end of the step
  Vec2* position = nullptr;        // of the body, after a last kick
  Vec2* velocity = nullptr;
  double* spin = nullptr;
  const Vec2* external = nullptr;  // N, on a particle at rest
  const double* drag = nullptr;    // kg/s
  Load* loads = nullptr;           // of contacts; zero after a drift
  double* spinAhead = nullptr;     // predicted likewise

  /// Half a step in velocity, a whole one in position; Euler's is a whole one in both. The drag of the step
  /// is that of the velocity with which the position moves, implicitly: v' = (v + dt/2 a) / (1 + dt/2
  /// drag/m), and its impulse exactly -drag times the displacement. Returns the square of the largest of
  /// these speeds; infinite where one is not finite.
  double drift(Range particles) const;
  /// The second half of a step in velocity, the last of several; Euler's has none. Returns likewise.
  double kick(Range particles) const;
  /// The second half of a step and the first of the next.
  double kickAndDrift(Range particles) const;
};

}  // namespace bedmix
