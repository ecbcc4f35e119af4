// SPDX-License-Identifier: MIT
#pragma once

#include "app/accuracy/design.h"

#include <map>
#include <string>
#include <vector>

namespace bedmix {

/// How many runs of how many settings the statistics are taken from.
struct StatisticsPlan {
  int presetSeeds = 0, otherSeeds = 0;  // runs of each preset, of each other setting
  double duration = 0.0;                // of a run, simulated s
  std::vector<std::string> dropped;     // what the budget did not allow, for people

  /// The paper's takes longer than all other presets together, and nothing is compared with it alone: four at
  /// most.
  int seeds(const Design& design, const std::string& setting) const;
};

/// Of each preset.
inline constexpr int usualRuns = 8;

/// The fullest plan that fits, of `runs` of each preset at most. What goes first are the settings that are no
/// presets, then runs of presets down to four of each, then their duration down to four tenths of the
/// scene's. `costs` are wall seconds per simulated second and setting, `budget` seconds on `cores` at once.
StatisticsPlan planStatistics(const Design& design, const std::map<std::string, double>& costs,
                              double duration, double interval, double budget, int cores, int runs);

}  // namespace bedmix
