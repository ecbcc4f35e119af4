// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/thread_team.h"
#include "engine/dem/contact_law.h"
#include "engine/dem/rows.h"
#include "engine/dem/wall_shape.h"

#include <cstddef>
#include <cstdint>

// The loops over contacts, in vectors. Arrays of contacts are padded to whole vectors of eight; what stands
// in the padding must be valid indices of the same block of particles.

namespace bedmix {

/// Where forces are evaluated: one a particle, spin in rad/s (null without friction). Radii (m), masses (kg)
/// and kinds are null where all are alike.
struct Motion {
  const Body* body;
  const double* spin;
  const double* radii = nullptr;
  const double* masses = nullptr;
  const std::uint8_t* kinds = nullptr;
  double time = 0.0;  // s, that walls are where they then are
};

/// Pairs that may touch, side by side; of them those in `slots`, which ends with a whole vector of eight or
/// with the last of all.
struct PairIndices {
  const std::int32_t* first;
  const std::int32_t* second;
  Range slots;
};

/// Tangential spring (m, along t = (-n_y, n_x), n to the other) and slip (m/s) of each contact before and
/// after; 0 for who does not touch. Both may be the same arrays. Null without friction.
struct Tangential {
  const double* spring;
  const double* slip;
  double* newSpring;
  double* newSlip;
  /// What effects keep, in place; null where there is none: the rolling spring (rad) and its rate (rad/s), 1
  /// where there is a liquid bridge.
  double* rolled = nullptr;
  double* rollRate = nullptr;
  double* bridge = nullptr;
};

struct KernelReport {
  /// m2, smallest squared distance of those that touch; reach^2 without any. With effects that of two of the
  /// law's reach with the deepest overlap there is.
  double closest2;
  std::size_t touching;  // contacts
};

/// A spring grows by halfStep (s) times its old and its new slip; at Coulomb's limit it is set so that spring
/// and dashpot together give just that. Without friction there is no tangential force, torque or spring.
/// With `onset` the force is not that at the instant but its mean over the step around it, through which the
/// bodies go on as they do: a contact that begins or ends within it acts for its part of it, and one already
/// acts that is up to half a step away. Velocities must be foreseen with the forces of the last step then.
struct ContactKernel {
  SpringDashpot law;
  double radius;        // m
  double particleMass;  // kg, of one
  double halfStep;      // s
  bool friction;
  bool onset;
  const ContactEffects* effects;  // null where contacts are alike linear springs

  /// Adds to both particles' loads.
  KernelReport pairs(const Motion& at, const PairIndices& pairs, const Tangential& t, Load* loads) const;
  /// Adds to the first particles' loads; what the second get goes to `second`, one a pair.
  KernelReport crossing(const Motion& at, const PairIndices& pairs, const Tangential& t, Load* loads,
                        Load* second) const;
  /// Particles at one wall.
  KernelReport wall(const Motion& at, const WallShape& wall, const std::int32_t* particle, std::size_t count,
                    const Tangential& t, Load* loads) const;
};

}  // namespace bedmix
