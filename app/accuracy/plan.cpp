// SPDX-License-Identifier: MIT
#include "app/accuracy/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr int otherRuns = 4, fewestRuns = 4;
constexpr double shortest = 0.4;  // of the scene's duration
constexpr double others = 1.25;   // a run takes so much longer beside others than alone

}  // namespace

int StatisticsPlan::seeds(const Design& design, const std::string& setting) const {
  const bool isPreset =
      std::find(design.presets.begin(), design.presets.end(), setting) != design.presets.end();
  if (setting == design.paper) return std::min(presetSeeds, fewestRuns);
  return isPreset ? presetSeeds : otherSeeds;
}

StatisticsPlan planStatistics(const Design& design, const std::map<std::string, double>& costs,
                              double duration, double interval, double budget, int cores, int runs) {
  StatisticsPlan plan{runs, std::min(runs, otherRuns), duration, {}};
  const auto wall = [&] {
    double sum = 0.0;
    for (const std::string& setting : design.statistics)
      if (const auto cost = costs.find(setting); cost != costs.end())
        sum += cost->second * plan.duration * plan.seeds(design, setting);
    return others * sum / cores;
  };
  if (wall() > budget) {
    plan.otherSeeds = 0;
    plan.dropped.emplace_back("statistics of all settings but the presets");
  }
  while (wall() > budget && plan.presetSeeds > fewestRuns) --plan.presetSeeds;
  if (plan.presetSeeds < runs)
    plan.dropped.push_back(fmt::format("{} of {} runs of each preset", runs - plan.presetSeeds, runs));
  for (auto frames = std::llround(duration / interval); wall() > budget;) {
    frames = std::llround(0.9 * static_cast<double>(frames));
    const double shorter = static_cast<double>(frames) * interval;
    if (shorter < shortest * duration || shorter >= plan.duration) break;
    plan.duration = shorter;
  }
  if (plan.duration < duration)
    plan.dropped.push_back(fmt::format("runs end after {:.3g} of {:g} s", plan.duration, duration));
  return plan;
}

}  // namespace bedmix
