// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/period.h"
#include "engine/core/scene.h"
#include "engine/effects/cohesion.h"

#include <optional>
#include <vector>

namespace bedmix {

/// The linear spring and dashpot of one kind of contact, Tian et al. (2007), Eqs (5) and (7). Tangential
/// constants are unused without friction. Where particles or contacts differ, see ContactEffects, those of
/// the lightest particle, which make the shortest steps, and the reach of the largest.
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

/// What contacts between two kinds of particles, or of one with walls, have of their own.
struct ContactMaterial {
  double damping = 0.0;   // dashpot over the root of reduced mass times spring
  double friction = 0.0;  // Coulomb's coefficient
};

/// What makes contacts more than alike linear springs: everything that a scene's effects say of them. A
/// contact's spring is then its own, as are its dashpot and its masses.
struct ContactEffects {
  bool hertz = false;
  double spring = 0.0;   // N/m; Hertzian: 4/3 E*, Pa, times the root of effective radius and overlap
  double dashpot = 0.0;  // kg/s, beside the material's
  double tangentialSpring = 0.0, tangentialDashpot = 0.0;  // over the normal ones
  /// By kinds of the two: first * (kinds + 1) + second, where walls come after the last kind.
  std::vector<ContactMaterial> materials;
  std::size_t kinds = 1;
  std::optional<RollingSettings> rolling;
  std::optional<CohesionSettings> cohesion;
  BridgeLaw pairBridge{}, wallBridge{};
  double range = 0.0;  // m, gap up to which there is an attraction
  Period period;       // by which two particles are the nearest of their images
};
/// None where contacts are alike linear springs.
std::optional<ContactEffects> contactEffects(const Scene& scene);

}  // namespace bedmix
