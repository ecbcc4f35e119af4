// SPDX-License-Identifier: MIT
#include "engine/core/scene.h"

namespace bedmix {

std::vector<Contradiction> contradictions(const Scene& scene, const LiftSettings& lift) {
  std::vector<Contradiction> broken;
  if (!scene.gas)
    broken.push_back({"lift", "[lift] is a force of the gas, and there is no [gas]; leave it out", {"gas"}});
  const bool spins = lift.spin != SpinLift::none;
  if (lift.shear == ShearLift::none && !spins)
    broken.push_back(
        {"lift.shear", "[lift] of neither shear nor spin does nothing; leave it out", {"lift.spin"}});
  if (spins && !scene.contacts.friction)
    broken.push_back(
        {"lift.spin",
         "particles only turn where there is [contacts.friction]; give it, or lift.spin = \"none\"",
         {"contacts.friction"}});
  return broken;
}

std::vector<Contradiction> contradictions(const Scene& scene, const VirtualMassSettings&) {
  if (scene.gas) return {};
  return {
      {"virtual_mass", "[virtual_mass] is inertia of the gas, and there is no [gas]; leave it out", {"gas"}}};
}

}  // namespace bedmix
