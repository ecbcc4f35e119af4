// SPDX-License-Identifier: MIT
#include "engine/effects/effects.h"

#include <fmt/format.h>

#include <array>

namespace bedmix {

namespace {

bool hasGas(const Scene& scene) { return scene.gas.has_value(); }
std::string gasNote(const Scene& scene) {
  const auto& gas = scene.gas;
  if (!gas) return "no table [gas]";
  return fmt::format("{}, {}, drag {}", modelName(gas->scheme), modelName(gas->timeScheme),
                     modelName(gas->drag));
}

bool hasFriction(const Scene& scene) { return scene.contacts.friction.has_value(); }
std::string frictionNote(const Scene& scene) {
  const auto& friction = scene.contacts.friction;
  if (!friction) return "no table [contacts.friction]; no rotation either";
  return fmt::format("coefficient {:g}; particles rotate", friction->coefficient);
}

constexpr std::array table{
    EffectInfo{"gas", "gas", hasGas, gasNote},
    EffectInfo{"contacts.friction", "friction", hasFriction, frictionNote},
};

}  // namespace

std::span<const EffectInfo> effectTable() { return table; }

}  // namespace bedmix
