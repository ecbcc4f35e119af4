// SPDX-License-Identifier: MIT
#pragma once

#include "engine/effects/face_charge.h"
#include "engine/effects/lift_laws.h"

#include <memory>
#include <vector>

namespace bedmix {

/// Lift of particles in the gas, LiftLaw, from both as they are at the start of a gas step, held over it; the
/// gas gets the opposite over the same time, to round-off. The torque brings spins closer to half the
/// vorticity, implicitly, so that none goes beyond it; the gas, whose equations know no couples, gets nothing
/// of it.
class LiftStage final : public EffectStage {
 public:
  /// None where the scene has no lift.
  static std::unique_ptr<EffectStage> make(const EffectContext& context);
  explicit LiftStage(const EffectContext& context);

  void follow(const PopulationChange& change) override;
  bool chargesGas() const override { return true; }
  void chargeGas(double step, MomentumExchange& exchange) override;
  void act(double passed, double step) override;

 private:
  const EffectContext context_;
  LiftLaw law_;
  FaceCharge faces_;
  // Per particle in memory, at the last charge: force, N, half the vorticity, 1/s, and the torque over how
  // much faster it turns, N m s.
  std::vector<Vec2> force_;
  std::vector<double> around_, resistance_;
};

}  // namespace bedmix
