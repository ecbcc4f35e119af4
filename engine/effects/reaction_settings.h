// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/contradiction.h"
#include "engine/core/key.h"
#include "engine/core/models.h"

#include <vector>

namespace bedmix {

/// What particles hold, moisture or a reactant, and how it goes; see ReactionStage.
struct ReactionSettings {
  static constexpr Key table{
      "reaction", "", {}, "switches on a content of the particles that reacts or dries"};

  double content = 0.1;  // kg/kg of the solid, at the start and of who comes in
  ReactionModel model = ReactionModel::firstOrder;
  double rate = 0.0;                     // 1/s, or of a constant one kg/(kg s)
  double activationEnergy = 0.0;         // J/mol
  double referenceTemperature = 293.15;  // K, at which the rate is that
  double heat = 0.0;                     // J a kg of what has gone; below 0 where that takes heat up
};

template <class V>
void describe(ReactionSettings& s, V& visit) {
  visit(Key{"content", "kg/kg", {0.0, 1.0, true}, "of the solid, at the start and of who comes in"},
        s.content);
  visit(Key{"model", "", {}, "how the content goes"}, s.model);
  visit(Key{"rate", "1/s", positive, "of it, at reference_temperature", true}, s.rate);
  visit(Key{"activation_energy", "J/mol", {0.0, 1e6}, "by which it goes faster where it is warm; needs heat"},
        s.activationEnergy);
  visit(Key{"reference_temperature", "K", {1.0, 5000.0}, "at which the rate is that"},
        s.referenceTemperature);
  visit(Key{"heat", "J/kg", {}, "that a kg of it gives as it goes; below 0 what it takes up; needs heat"},
        s.heat);
}

std::vector<Contradiction> contradictions(const Scene& scene, const ReactionSettings& reaction);

}  // namespace bedmix
