// SPDX-License-Identifier: MIT
#include "engine/dem/contact_law.h"

namespace bedmix {

namespace {

SpringDashpot contactLaw(const Scene& scene, double mass, double reach, double damping) {
  SpringDashpot law;
  law.mass = mass;
  law.tangentialMass = 2.0 / 7.0 * mass;  // a sphere's inertia is 2/5 m r^2
  law.reach = reach;
  law.stiffness = scene.contacts.stiffness;
  law.damping = damping;
  if (const auto& friction = scene.contacts.friction) {
    law.tangentialStiffness = friction->stiffnessRatio * law.stiffness;
    law.tangentialDamping = friction->dampingRatio * damping;
    law.friction = friction->coefficient;
  }
  return law;
}

}  // namespace

SpringDashpot pairLaw(const Scene& scene) {
  return contactLaw(scene, particleMass(scene) / 2.0, scene.particles.diameter, pairDamping(scene));
}
SpringDashpot wallLaw(const Scene& scene) {
  return contactLaw(scene, particleMass(scene), scene.particles.diameter / 2.0, wallDamping(scene));
}

}  // namespace bedmix
