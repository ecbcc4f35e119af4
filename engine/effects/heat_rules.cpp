// SPDX-License-Identifier: MIT
#include "engine/core/particle_list.h"
#include "engine/effects/heat_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace bedmix {

double longestHeatStep(const Scene& scene) {
  constexpr double neighbours = 6.0;
  const ParticleRange range = particleRange(scene);
  const double reduced = 0.5 * range.smallest * range.largest / (range.smallest + range.largest);
  const double between = ConductionLaw(scene).pair(scene.limits.maxOverlap * range.smallest, reduced);
  const double capacity = scene.effects.find<HeatSettings>()->heatCapacity * range.lightest;
  return between > 0.0 ? 0.5 * capacity / (neighbours * between) : infinity;
}

std::vector<Contradiction> contradictions(const Scene& scene, const HeatSettings& heat) {
  std::vector<Contradiction> broken;
  const auto add = [&](std::string path, std::vector<std::string> concerns, std::string message) {
    broken.push_back({std::move(path), std::move(message), std::move(concerns)});
  };
  if (scene.gas && !heat.gas)
    add("heat.gas", {"gas"},
        "[heat] needs the table [heat.gas] where there is [gas]: heat capacity, conductivity and temperature "
        "of "
        "the gas; empty it means air at 293.15 K");
  if (!scene.gas && heat.gas)
    add("heat.gas", {"gas"}, "[heat.gas] says what gas does, and there is no [gas]; leave it out");
  const auto holds = [&](const char* path, const StepLength& step) {
    const double longest = longestHeatStep(scene);
    if (step.isAutomatic() || step <= longest) return;
    add(path, {"heat.conductivity", "heat.heat_capacity", "limits.max_overlap"},
        fmt::format(
            "a step of {} s is too long for heat through contacts, which particles may pass on within "
            "{:.3g} s: their temperatures would overshoot each other. Take at most {:.3g} s, or give "
            "heat.youngs_modulus",
            static_cast<double>(step), 2.0 * longest, longest));
  };
  if (scene.gas)
    holds("gas.step", scene.gas->step);
  else
    holds("time.step", scene.time.step);
  return broken;
}

std::string heatNote(const Scene& scene) {
  const HeatSettings& heat = *scene.effects.find<HeatSettings>();
  std::string note = fmt::format("{:g} J/(kg K)", heat.heatCapacity);
  if (!heat.gas || !scene.gas || !(heat.conductivity > 0.0)) return note;
  double flow = 0.0;
  for (const Inlet& inlet : scene.gas->inlets) flow += inletVelocity(scene, inlet) * (inlet.to - inlet.from);
  const ConvectionLaw law(scene);
  const double reynolds = law.reynoldsPerSlip * flow / scene.bed.width;
  double nusselt = 0.0;
  gunnNusselt(law.prandtl, 1, &packedVoidage, &reynolds, &nusselt);
  const double biot = nusselt * heat.gas->conductivity / (6.0 * heat.conductivity);
  return note + fmt::format(", Biot number {:.2g}{}", biot,
                            biot > 0.1 ? ": particles are not as warm inside as outside" : "");
}

}  // namespace bedmix
