// SPDX-License-Identifier: MIT
#include "engine/core/inlet_flow.h"

#include <algorithm>

namespace bedmix {

namespace {

constexpr double stepsInAPeriod = 40.0;

}  // namespace

bool InletFlow::changes(const Scene& scene) {
  return std::any_of(scene.gas->inlets.begin(), scene.gas->inlets.end(),
                     [](const Inlet& inlet) { return inlet.pulse || !inlet.schedule.empty(); });
}

InletFlow::InletFlow(const Scene& scene, const GasGrid& grid)
    : inlets_(scene.gas->inlets),
      factors_(inlets_.size(), 1.0),
      flux_(grid.inletFlux.size(), 0.0),
      longestStep_(infinity),
      fastest_(fastestInlet(scene)) {
  for (std::size_t i = 0; i < inlets_.size(); ++i) {
    if (inlets_[i].pulse)
      longestStep_ = std::min(longestStep_, 1.0 / (stepsInAPeriod * inlets_[i].pulse->frequency));
    for (std::size_t c = 0; c < flux_.size(); ++c) {
      const double covered = std::min(grid.x[c + 1], inlets_[i].to) - std::max(grid.x[c], inlets_[i].from);
      if (covered > 0.0 && grid.inletFlux[c] > 0.0)  // else what enters there is left out
        parts_.push_back({i, c, covered / (grid.x[c + 1] - grid.x[c]) * inletVelocity(scene, inlets_[i])});
    }
  }
}

const std::vector<double>& InletFlow::over(double from, double length) {
  for (std::size_t i = 0; i < inlets_.size(); ++i) {
    factors_[i] = factorAt(inlets_[i].schedule, from + 0.5 * length);
    if (inlets_[i].pulse) factors_[i] *= meanOf(*inlets_[i].pulse, from, length);
  }
  std::fill(flux_.begin(), flux_.end(), 0.0);
  for (const Part& part : parts_) flux_[part.column] += factors_[part.inlet] * part.flux;
  return flux_;
}

}  // namespace bedmix
