// SPDX-License-Identifier: MIT
#include "engine/coupling/gas_step.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr double courantLimit = 0.5;  // cells that the gas passes in a step
constexpr double firstShare = 0.01;   // of that, at the start
constexpr double growth = 2.0;        // from one step to the next
constexpr double forgetting = 0.1;    // of a rate that has fallen, in a step

}  // namespace

GasStep::GasStep(const Scene& scene, const GasSolver& gas)
    : allowed_(scene.gas->error),
      bound_(std::min(longestGasStep(scene), scene.sampling.interval)),
      longest_(bound_),
      drag_(gas.exchange().source.size()) {
  double fastest = 0.0;
  for (const Inlet& inlet : scene.gas->inlets) fastest = std::max(fastest, inletVelocity(scene, inlet));
  if (fastest > 0.0) longest_ = std::min(bound_, firstShare * courantLimit * gas.grid().dy(0) / fastest);
}

void GasStep::observe(const GasSolver& gas, const GasStepReport& report, double step, double before) {
  const MomentumExchange& exchange = gas.exchange();
  double change = 0.0, size = 0.0;
  for (std::size_t f = 0; f < drag_.size(); ++f) {
    const double now = exchange.source[f] - exchange.coefficient[f] * gas.fields().velocity[f];
    change += std::abs(now - drag_[f]);
    size += std::abs(now);
    drag_[f] = now;
  }
  const double rate = size > 0.0 ? change / (size * before) : 0.0;
  rate_ = std::max(rate, rate_ + forgetting * (rate - rate_));
  longest_ = std::min(bound_, growth * step);
  if (rate_ > 0.0) longest_ = std::min(longest_, allowed_ / rate_);
  if (report.courant > 0.0) longest_ = std::min(longest_, courantLimit * step / report.courant);
}

void GasStep::save(StateWriter& out) const {
  out.put(longest_);
  out.put(rate_);
  out.putAll(drag_);
}

bool GasStep::load(StateReader& in) {
  return in.get(longest_) && longest_ > 0.0 && in.get(rate_) && in.getAll(drag_);
}

}  // namespace bedmix
