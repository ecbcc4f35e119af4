// SPDX-License-Identifier: MIT
#include "engine/effects/virtual_mass_stage.h"

#include "engine/dem/particle_solver.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

std::unique_ptr<EffectStage> VirtualMassStage::make(const EffectContext& context) {
  if (!context.scene.effects.find<VirtualMassSettings>()) return nullptr;
  return std::make_unique<VirtualMassStage>(context);
}

VirtualMassStage::VirtualMassStage(const EffectContext& context)
    : context_(context),
      settings_(*context.scene.effects.find<VirtualMassSettings>()),
      faces_(context),
      added_(context.solver.particles().size()),
      start_(added_.size()),
      force_(added_.size()),
      flow_(added_.size()),
      carried_(added_.size()),
      atOnce_(added_.size()) {
  Particles& particles = context_.solver.particles();
  particles.addInertia();
  setInertia();
}

/// Of what the particles accelerate with the virtual mass they have; they turn as without.
void VirtualMassStage::setInertia() {
  Particles& particles = context_.solver.particles();
  const Roster& roster = context_.solver.roster();
  for (std::size_t i = 0; i < added_.size(); ++i) {
    const double mass = particles.massOf(i);
    particles.inert[i] = mass + added_[roster.rowOf(particles.id[i])];
    particles.gyration[i] = particles.radiusOf(i) * std::sqrt(mass / particles.inert[i]);
  }
}

void VirtualMassStage::follow(const PopulationChange& change) {
  change.apply(added_, [](const PopulationChange::Newcomer&) { return 0.0; });
  change.apply(start_, [](const PopulationChange::Newcomer& newcomer) { return newcomer.velocity; });
  change.apply(force_, [](const PopulationChange::Newcomer&) { return Vec2(); });
  for (auto* column : {&flow_, &carried_}) column->resize(added_.size());
  atOnce_.resize(added_.size());
  setInertia();
}

void VirtualMassStage::chargeGas(double step, MomentumExchange& exchange) {
  constexpr double least = 1e-300;  // kg, to divide by
  const Particles& particles = context_.solver.particles();
  const Roster& roster = context_.solver.roster();
  const double density = context_.scene.gas->density;
  faces_.charge(exchange, [&](const ExchangeBatch& batch, const FlowThere* flow, FaceCharge::Given* given) {
    for (std::size_t i = 0; i < batch.size; ++i) {
      const std::size_t p = batch.begin + i, row = roster.rowOf(particles.id[p]);
      const Vec2 due = added_[row] * (particles.velocity[p] - start_[row]);
      const Vec2 u = flow[i].velocity;
      flow_[p] = u;
      carried_[p] = u.x * flow[i].perX + u.y * flow[i].perY;
      const double voidage = batch.voidage[i], displaced = density * batch.shares.coupledVolume[i];
      added_[row] = settings_.coefficientAt(voidage) * displaced;
      start_[row] = particles.velocity[p];
      const double heldBack =
          added_[row] * (1.0 / (voidage * voidage) - 1.0) + displaced * (1.0 - voidage) / voidage;
      atOnce_[p] = std::min(1.0, (particles.massOf(p) + added_[row]) / std::max(heldBack, least));
      given[i] = {added_[row] / step, 1.0 / step * due - added_[row] * carried_[p]};
    }
  });
}

void VirtualMassStage::act(double, double step) {
  Particles& particles = context_.solver.particles();
  const Roster& roster = context_.solver.roster();
  faces_.visit([&](const ExchangeBatch& batch, const FlowThere* flow) {
    for (std::size_t i = 0; i < batch.size; ++i) {
      const std::size_t p = batch.begin + i;
      const Vec2 u = flow[i].velocity, gain = 1.0 / step * (u - flow_[p]) + carried_[p];
      const Vec2 dragging = particles.drag[p] * u;
      const std::size_t row = roster.rowOf(particles.id[p]);
      const double added = added_[row];
      Vec2& force = force_[row];
      force += atOnce_[p] * (particles.external[p] - dragging + added * gain - force);
      // The virtual mass has no weight.
      particles.external[p] = dragging + force + Vec2{0.0, added * context_.scene.gravity};
    }
  });
  setInertia();
}

void VirtualMassStage::hashInto(StateHash& hash) const {
  hash.add(added_);
  for (const auto* column : {&start_, &force_})
    for (const Vec2 v : *column) {
      hash.add(v.x);
      hash.add(v.y);
    }
}

void VirtualMassStage::save(StateWriter& out) const {
  out.putAll(added_);
  out.putAll(start_);
  out.putAll(force_);
}

bool VirtualMassStage::load(StateReader& in) {
  if (!(in.getAll(added_) && in.getAll(start_) && in.getAll(force_))) return false;
  if (!std::all_of(added_.begin(), added_.end(), [](double m) { return m >= 0.0; })) return false;
  setInertia();
  return true;
}

}  // namespace bedmix
