// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace bedmix {

/// What a dimensionless number says of an effect: whether it matters in a scene, be it there or not.
struct EffectAdvice {
  std::string_view table;   // of the effect
  std::string_view number;  // its name
  double value = 0.0;
  bool isOn = false;
  bool matters = false;
  std::string meaning;  // what it is, from where on it matters, and who says so
};
/// What can be told without knowing more than the scene; of what it leaves open, values of dry glass in air.
std::vector<EffectAdvice> effectAdvice(const Scene& scene);

}  // namespace bedmix
