// SPDX-License-Identifier: MIT
#pragma once

#include "engine/effects/face_charge.h"

#include <memory>
#include <vector>

namespace bedmix {

/// Virtual mass m_a = C rho V of particles in the gas, Auton, Hunt & Prud'homme (1988), J. Fluid Mech.
/// 197:241:
///   F = m_a (du/dt + (u grad) u - dv/dt)
/// with the gas's own derivative. Particles have it as a part of their inertia (but not of their weight, nor
/// where they turn), so that none is too light; m_a stays what it is over a gas step. The gas gets the
/// opposite: of du/dt in the same step, with the same weights and implicitly, so that it is heavier by m_a;
/// of m_a dv/dt over a step what it has come to, in the next one. What one phase gives is what the other
/// gets, to round-off.
///
/// Gas that makes room for particles is accelerated against them, dv/dt (1-eps)/eps, and by its pressure and
/// what they take along holds them back, one gas step later, with
///   r (m + m_a) dv/dt,   r = (m_a (1/eps^2 - 1) + rho V (1-eps)/eps)/(m + m_a),
/// of which more than twice (m + m_a) dv/dt would grow from step to step. So where r is above 1, in dense
/// beds of light particles, they feel 1/r of the change of that force in the step and the rest in the next
/// ones.
class VirtualMassStage final : public EffectStage {
 public:
  /// None where the scene has no virtual mass.
  static std::unique_ptr<EffectStage> make(const EffectContext& context);
  explicit VirtualMassStage(const EffectContext& context);

  void follow(const PopulationChange& change) override;
  bool chargesGas() const override { return true; }
  void chargeGas(double step, MomentumExchange& exchange) override;
  void act(double passed, double step) override;
  void hashInto(StateHash& hash) const override;
  void save(StateWriter& out) const override;
  [[nodiscard]] bool load(StateReader& in) override;

 private:
  void setInertia();

  const EffectContext context_;
  VirtualMassSettings settings_;
  FaceCharge faces_;
  // By row of the roster: virtual mass, kg, and velocity, m/s, at the last charge.
  std::vector<double> added_;
  std::vector<Vec2> start_;
  std::vector<Vec2> force_;  // N, likewise: of the gas's pressure and acceleration, as felt last
  // Per particle in memory, at the last charge: velocity of the gas, m/s, (u grad) u, m/s2, and what of a
  // change of the force it feels at once.
  std::vector<Vec2> flow_, carried_;
  std::vector<double> atOnce_;
};

}  // namespace bedmix
