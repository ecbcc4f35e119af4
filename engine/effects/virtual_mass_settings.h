// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/contradiction.h"
#include "engine/core/key.h"
#include "engine/core/models.h"

#include <vector>

namespace bedmix {

/// The gas that particles take along where they or it accelerate, C rho V; see VirtualMassStage. Of a sphere
/// C = 1/2, Auton, Hunt & Prud'homme (1988); among others, Zuber (1964), Chem. Eng. Sci. 19:897, at the
/// volume fraction a of particles, C (1 + 2 a)/(1 - a).
struct VirtualMassSettings {
  static constexpr Key table{
      "virtual_mass", "", {}, "switches on the inertia of the gas that particles take along"};

  double coefficient = 0.5;
  Crowding crowding = Crowding::zuber;

  double coefficientAt(double voidage) const {
    return crowding == Crowding::zuber ? coefficient * (3.0 - 2.0 * voidage) / voidage : coefficient;
  }
};

template <class V>
void describe(VirtualMassSettings& s, V& visit) {
  visit(Key{"coefficient", "", notNegative, "of a particle alone, over the gas it displaces"}, s.coefficient);
  visit(Key{"crowding", "", {}, "how it grows where particles are dense"}, s.crowding);
}

std::vector<Contradiction> contradictions(const Scene& scene, const VirtualMassSettings& settings);

}  // namespace bedmix
