// SPDX-License-Identifier: MIT
#include "engine/dem/contact_law.h"

#include "engine/core/particle_list.h"

#include <cmath>
#include <numbers>
#include <string_view>

namespace bedmix {

namespace {

/// Tangential over normal spring: of a Hertzian contact 8 G* a over 4/3 E* a, Mindlin (1949).
double tangentialRatio(const ContactSettings& contacts) {
  if (!contacts.friction) return 0.0;
  if (!contacts.hertz) return contacts.friction->stiffnessRatio;
  const double nu = contacts.hertz->poissonRatio;
  return 3.0 * (1.0 - nu) / (2.0 - nu);
}

SpringDashpot contactLaw(const Scene& scene, double mass, double reach, double damping) {
  SpringDashpot law;
  law.mass = mass;
  law.tangentialMass = 2.0 / 7.0 * mass;  // a sphere's inertia is 2/5 m r^2
  law.reach = reach;
  law.stiffness = normalStiffness(scene);
  law.damping = damping;
  if (const auto& friction = scene.contacts.friction) {
    law.tangentialStiffness = tangentialRatio(scene.contacts) * law.stiffness;
    law.tangentialDamping = friction->dampingRatio * damping;
    law.friction = friction->coefficient;
  }
  return law;
}

/// The dashpot that gives a restitution, over the root of reduced mass times spring; of a Hertzian one after
/// Antypov & Elliott (2011), Europhys. Lett. 94:50004, whose spring is the secant one.
double dampingFactor(double restitution, bool hertz) {
  const double linear = dampingFor(restitution, 1.0, 1.0);
  return hertz ? 0.5 * std::sqrt(5.0) * linear : linear;
}

std::vector<ContactMaterial> contactMaterials(const Scene& scene) {
  const ContactSettings& c = scene.contacts;
  const std::vector<ParticleKind> kinds = particleKinds(scene);
  const auto nameOf = [&](std::size_t k) { return k < kinds.size() ? kinds[k].name : "wall"; };
  std::vector<ContactMaterial> materials;
  for (std::size_t first = 0; first < kinds.size(); ++first)
    for (std::size_t second = 0; second <= kinds.size(); ++second) {
      std::optional<double> restitution = c.restitution;
      double friction = c.friction ? c.friction->coefficient : 0.0;
      for (const PairSettings& pair : c.pairs) {
        const bool isThis = (pair.first == nameOf(first) && pair.second == nameOf(second)) ||
                            (pair.first == nameOf(second) && pair.second == nameOf(first));
        if (!isThis) continue;
        if (pair.restitution) restitution = pair.restitution;
        friction = pair.friction.value_or(friction);
      }
      materials.push_back({restitution ? dampingFactor(*restitution, c.hertz.has_value()) : 0.0, friction});
    }
  return materials;
}

}  // namespace

SpringDashpot pairLaw(const Scene& scene) {
  return contactLaw(scene, lightestMass(scene) / 2.0, particleRange(scene).largest, pairDamping(scene));
}
SpringDashpot wallLaw(const Scene& scene) {
  return contactLaw(scene, lightestMass(scene), particleRange(scene).largest / 2.0, wallDamping(scene));
}

std::optional<ContactEffects> contactEffects(const Scene& scene) {
  const ContactSettings& c = scene.contacts;
  const CohesionSettings* cohesion = scene.effects.find<CohesionSettings>();
  const Period period(scene);
  if (!isMixed(scene) && !c.hertz && !c.rolling && !cohesion && c.pairs.empty() && !period.isOn())
    return std::nullopt;
  ContactEffects effects;
  effects.period = period;
  effects.hertz = c.hertz.has_value();
  effects.spring = c.hertz ? 4.0 / 3.0 * effectiveModulus(*c.hertz) : *c.stiffness;
  effects.dashpot = c.damping.value_or(0.0);
  effects.tangentialSpring = tangentialRatio(c);
  effects.tangentialDashpot = c.friction ? c.friction->dampingRatio : 0.0;
  effects.materials = contactMaterials(scene);
  effects.kinds = particleKinds(scene).size();
  effects.rolling = c.rolling;
  if (cohesion) {
    effects.cohesion = *cohesion;
    if (cohesion->liquidBridge) {
      effects.pairBridge = pairBridge(*cohesion->liquidBridge);
      effects.wallBridge = wallBridge(*cohesion->liquidBridge);
    }
    effects.range = cohesionRange(scene);
  }
  return effects;
}

}  // namespace bedmix
