// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

namespace bedmix {

/// The linear spring and dashpot of one kind of contact, Tian et al. (2007), Eqs (5) and (7). Tangential
/// constants are unused without friction.
struct SpringDashpot {
  double mass = 0.0;                 // kg, that the spring swings: reduced, of two; of one at a wall
  double tangentialMass = 0.0;       // kg, that the tangential spring swings, with what turns
  double reach = 0.0;                // m, distance of the centre from the other's centre or the wall at touch
  double stiffness = 0.0;            // N/m
  double damping = 0.0;              // kg/s
  double tangentialStiffness = 0.0;  // N/m
  double tangentialDamping = 0.0;    // kg/s
  double friction = 0.0;             // Coulomb's coefficient
};
SpringDashpot pairLaw(const Scene& scene);
SpringDashpot wallLaw(const Scene& scene);

}  // namespace bedmix
