// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace bedmix {

/// What an effect that is on costs a particle in a step, measured here.
struct EffectPrice {
  std::string name;
  std::optional<double> nanoseconds;  // none where the scene cannot do without it
  std::string with;                   // what had to be left out, too
};

struct EffectPrices {
  double whole = 0.0;     // ns, a particle's step with all that is on
  double contacts = 0.0;  // of a particle, on average
  std::vector<EffectPrice> effects;
};

/// Runs the scene's particles, packed in a square, for a moment with and without each of its effects, by
/// turns. Obstacles and drums are left out. Empty where the bed is too large for a moment, or breaks.
std::optional<EffectPrices> measureEffectPrices(const Scene& scene);

}  // namespace bedmix
