// SPDX-License-Identifier: MIT
#include "engine/effects/lift_stage.h"

#include "engine/dem/particle_solver.h"

#include <cmath>

namespace bedmix {

std::unique_ptr<EffectStage> LiftStage::make(const EffectContext& context) {
  if (!context.scene.effects.find<LiftSettings>()) return nullptr;
  return std::make_unique<LiftStage>(context);
}

LiftStage::LiftStage(const EffectContext& context)
    : context_(context),
      law_(*context.scene.gas, *context.scene.effects.find<LiftSettings>()),
      faces_(context),
      force_(context.solver.particles().size()) {
  if (law_.models.spin == SpinLift::none) return;
  around_.resize(force_.size());
  resistance_.resize(force_.size());
}

// All that is kept is made anew before it is used.
void LiftStage::follow(const PopulationChange&) {
  force_.resize(context_.solver.particles().size());
  if (law_.models.spin == SpinLift::none) return;
  around_.resize(force_.size());
  resistance_.resize(force_.size());
}

void LiftStage::chargeGas(double, MomentumExchange& exchange) {
  const Particles& particles = context_.solver.particles();
  const bool turns = law_.models.spin != SpinLift::none;
  faces_.charge(exchange, [&](const ExchangeBatch& batch, const FlowThere* flow, FaceCharge::Given* given) {
    double slip[batchSize], vorticity[batchSize], spin[batchSize], diameter[batchSize];
    double lift[batchSize], resistance[batchSize];
    for (std::size_t i = 0; i < batch.size; ++i) {
      const std::size_t p = batch.begin + i;
      const Vec2 w = flow[i].velocity - particles.velocity[p];
      slip[i] = std::sqrt(dot(w, w));
      vorticity[i] = flow[i].vorticity();
      spin[i] = turns ? particles.spin[p] : 0.0;
      diameter[i] = 2.0 * particles.radiusOf(p);
    }
    law_.evaluate({batch.size, slip, vorticity, spin, diameter}, lift, resistance);
    for (std::size_t i = 0; i < batch.size; ++i) {
      const std::size_t p = batch.begin + i;
      const double share = faces_.coupledShare(batch, i);
      const Vec2 w = flow[i].velocity - particles.velocity[p];
      force_[p] = share * lift[i] * Vec2{w.y, -w.x};
      given[i].source = -1.0 * force_[p];
      if (!turns) continue;
      around_[p] = 0.5 * vorticity[i];
      resistance_[p] = share * resistance[i];
    }
  });
}

void LiftStage::act(double, double step) {
  Particles& particles = context_.solver.particles();
  for (std::size_t i = 0; i < force_.size(); ++i) particles.external[i] += force_[i];
  for (std::size_t i = 0; i < around_.size(); ++i) {
    const double pull = step * resistance_[i] / particles.inertiaOf(i);
    particles.spin[i] = (particles.spin[i] + pull * around_[i]) / (1.0 + pull);
  }
}

}  // namespace bedmix
