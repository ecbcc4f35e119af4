// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/contradiction.h"
#include "engine/core/key.h"
#include "engine/core/models.h"

#include <vector>

namespace bedmix {

/// Forces across the slip: of the gas's shear and of the particles' spin; see LiftLaw.
struct LiftSettings {
  static constexpr Key table{
      "lift", "", {}, "switches on forces of the gas across the slip, by its shear and by spin"};

  ShearLift shear = ShearLift::mei;
  SpinLift spin = SpinLift::lunLiu;
};

template <class V>
void describe(LiftSettings& s, V& visit) {
  visit(Key{"shear", "", {}, "by shear of the gas"}, s.shear);
  visit(Key{"spin", "", {}, "by spin, with the torque by which the gas resists it; needs contacts.friction"},
        s.spin);
}

std::vector<Contradiction> contradictions(const Scene& scene, const LiftSettings& lift);

}  // namespace bedmix
