// SPDX-License-Identifier: MIT
#pragma once

#include "engine/effects/effect_stage.h"

#include <memory>
#include <vector>

namespace bedmix {

/// A content X of each particle that dries or reacts, as a source on it alone:
///   dX/dt = -k X, or -k until there is none; k = rate exp(-E/R (1/T - 1/T_ref)) (Arrhenius),
///   c dT/dt = -heat dX/dt,
/// exactly over a gas step (without gas: as often as heat and feed ask for) at the temperature that the
/// particle has then. The gas knows nothing of what comes out of particles, whose mass and size stay.
class ReactionStage final : public EffectStage {
 public:
  /// None where the scene has no reaction.
  static std::unique_ptr<EffectStage> make(const EffectContext& context);
  explicit ReactionStage(const EffectContext& context);

  void follow(const PopulationChange& change) override;
  void act(double passed, double step) override;
  void fill(Frame& frame) const override;
  void hashInto(StateHash& hash) const override;
  void save(StateWriter& out) const override;
  [[nodiscard]] bool load(StateReader& in) override;

 private:
  const EffectContext context_;
  const ReactionSettings& settings_;
  std::vector<double> content_;  // by row of the roster
  std::size_t newcomers_ = 0;    // the last ones, for whom nothing has passed yet
};

}  // namespace bedmix
