// SPDX-License-Identifier: MIT
#include "engine/core/scene.h"
#include "engine/effects/reaction_settings.h"

namespace bedmix {

std::vector<Contradiction> contradictions(const Scene& scene, const ReactionSettings& reaction) {
  std::vector<Contradiction> broken;
  if (scene.effects.find<HeatSettings>()) return broken;
  if (reaction.activationEnergy != 0.0)
    broken.push_back(
        {"reaction.activation_energy",
         "the rate follows the particles' temperature, and there is no [heat]; give it, or leave "
         "activation_energy out",
         {"heat"}});
  if (reaction.heat != 0.0)
    broken.push_back(
        {"reaction.heat",
         "what the reaction gives or takes changes temperatures, and there is no [heat]; give it, "
         "or leave reaction.heat out",
         {"heat"}});
  return broken;
}

}  // namespace bedmix
