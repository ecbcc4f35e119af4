// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/contradiction.h"
#include "engine/core/key.h"

#include <optional>
#include <vector>

namespace bedmix {

/// Hamaker (1937): F = A R/(6 s^2), R = r1 r2/(r1 + r2), with the gap s not below the least.
struct VanDerWaalsSettings {
  double hamaker = 1e-19;   // J
  double leastGap = 4e-10;  // m, of surfaces that touch
  double cutoff = 1e-6;     // m, gap beyond which there is no force
};

/// Mikami, Kamiya & Horio (1998), Chem. Eng. Sci. 53:1927: F = pi R gamma (exp(A h/R + B) + C) until the
/// bridge breaks, which forms where bodies touch.
struct LiquidBridgeSettings {
  double surfaceTension = 0.072;  // N/m
  double volume = 1e-3;           // of a bridge, over the cube of the radius
  double contactAngleDeg = 0.0;
};

/// Cohesive energy density times the area of contact (Johnson, Kendall & Roberts, simplified).
struct SjkrSettings {
  double energyDensity = 1e5;  // J/m3
};

/// Attraction between particles, and to walls.
struct CohesionSettings {
  static constexpr Key table{"cohesion", "", {}, "switches on attraction; give one of its tables"};

  std::optional<VanDerWaalsSettings> vanDerWaals;
  std::optional<LiquidBridgeSettings> liquidBridge;
  std::optional<SjkrSettings> sjkr;
};

template <class V>
void describe(VanDerWaalsSettings& s, V& visit) {
  visit(Key{"hamaker", "J", positive, "Hamaker's constant", true}, s.hamaker);
  visit(Key{"least_gap", "m", positive, "gap of surfaces that touch"}, s.leastGap);
  visit(Key{"cutoff", "m", positive, "gap beyond which there is no attraction"}, s.cutoff);
}
template <class V>
void describe(LiquidBridgeSettings& s, V& visit) {
  visit(Key{"surface_tension", "N/m", positive, "of the liquid", true}, s.surfaceTension);
  visit(Key{"volume", "", {1e-6, 0.1}, "of the liquid in a bridge, over the cube of the radius"}, s.volume);
  visit(Key{"contact_angle_deg", "deg", {0.0, 60.0}, "of the liquid on the solid"}, s.contactAngleDeg);
}
template <class V>
void describe(SjkrSettings& s, V& visit) {
  visit(Key{"energy_density", "J/m3", positive, "attraction per area of contact", true}, s.energyDensity);
}
template <class V>
void describe(CohesionSettings& s, V& visit) {
  visit(Key{"van_der_waals", "", {}, "by van der Waals forces"}, s.vanDerWaals);
  visit(Key{"liquid_bridge", "", {}, "by liquid bridges"}, s.liquidBridge);
  visit(Key{"sjkr", "", {}, "in proportion to the area of contact"}, s.sjkr);
}

std::vector<Contradiction> contradictions(const Scene& scene, const CohesionSettings& cohesion);

/// Largest gap at which there is an attraction, m.
double cohesionRange(const Scene& scene);
/// Pull between two particles of the mean size at touch, N; 0 without cohesion. Over a particle's weight it
/// is the granular Bond number.
double pullAtTouch(const Scene& scene);

/// Mikami et al. (1998), Eqs (14) to (17): with gaps h in radii, F = pi R gamma (exp(a h + b) + c) up to
/// `rupture`.
struct BridgeLaw {
  double a, b, c, rupture;
};
BridgeLaw pairBridge(const LiquidBridgeSettings& liquid);
BridgeLaw wallBridge(const LiquidBridgeSettings& liquid);

}  // namespace bedmix
