// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

#include <span>
#include <string>
#include <string_view>

namespace bedmix {

/// What is to be known of an effect without running it. Each is on or off for a whole run, as what it keeps
/// is part of the run's state.
struct EffectInfo {
  std::string_view table;  // that switches it on, dotted
  std::string_view name;
  bool (*isOn)(const Scene&);
  /// How it is on, or what its absence means, in a few words.
  std::string (*note)(const Scene&);
};

/// All effects, in the order of a scene's tables.
std::span<const EffectInfo> effectTable();

}  // namespace bedmix
