// SPDX-License-Identifier: MIT
#include "engine/coupling/gas_step.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

// Cells; the coarse one is a whole cell less what the gas may gain within a step.
constexpr double fineCourant = 0.5, coarseCourant = 0.9;
constexpr double coarse = 0.1;       // gas.error from which on the latter counts
constexpr double firstShare = 0.01;  // of that, at the start
constexpr double growth = 2.0;       // from one step to the next
constexpr double forgetting = 0.1;   // of a rate that has fallen, in a step

}  // namespace

double GasStep::courantLimit(const GasSettings& settings) {
  return settings.error < coarse ? fineCourant : coarseCourant;
}

GasStep::GasStep(const Scene& scene, const GasSolver& gas)
    : allowed_(scene.gas->error),
      courantLimit_(courantLimit(*scene.gas)),
      bound_(std::min(longestGasStep(scene), scene.sampling.interval)),
      longest_(bound_),
      drag_(gas.exchange().source.size()) {
  const double fastest = fastestInlet(scene);
  if (fastest > 0.0) longest_ = std::min(bound_, firstShare * courantLimit_ * gas.grid().dy(0) / fastest);
}

void GasStep::expect(const GasSolver& gas, double fastest) {
  if (fastest > 0.0) longest_ = std::min(longest_, courantLimit_ * gas.grid().dy(0) / fastest);
}

void GasStep::observe(const GasSolver& gas, const MomentumExchange& drag, const GasStepReport& report,
                      double step, double before) {
  double change = 0.0, size = 0.0;
  for (std::size_t f = 0; f < drag_.size(); ++f) {
    const double now = drag.source[f] - drag.coefficient[f] * gas.fields().velocity[f];
    change += std::abs(now - drag_[f]);
    size += std::abs(now);
    drag_[f] = now;
  }
  const double rate = size > 0.0 ? change / (size * before) : 0.0;
  rate_ = std::max(rate, rate_ + forgetting * (rate - rate_));
  longest_ = std::min(bound_, growth * step);
  if (rate_ > 0.0) longest_ = std::min(longest_, allowed_ / rate_);
  if (report.courant > 0.0) longest_ = std::min(longest_, courantLimit_ * step / report.courant);
}

void GasStep::save(StateWriter& out) const {
  out.put(longest_);
  out.put(rate_);
  out.putAll(drag_);
}

bool GasStep::load(StateReader& in) {
  if (!(in.get(longest_) && longest_ > 0.0 && in.get(rate_) && in.getAll(drag_))) return false;
  longest_ = std::min(longest_, bound_);  // which another viscosity may have brought closer
  return true;
}

}  // namespace bedmix
