// SPDX-License-Identifier: MIT
#include "engine/effects/effect_stage.h"

#include "engine/effects/feed_stage.h"
#include "engine/effects/heat_stage.h"
#include "engine/effects/lift_stage.h"
#include "engine/effects/reaction_stage.h"
#include "engine/effects/virtual_mass_stage.h"

#include <array>

namespace bedmix {

namespace {

using Make = std::unique_ptr<EffectStage> (*)(const EffectContext&);

/// Each makes its stage, or none where the scene does not have its table.
constexpr std::array<Make, 5> makers{
    FeedStage::make,        HeatStage::make,
    ReactionStage::make,     // at the temperature that this has found
    VirtualMassStage::make,  // before any other that adds to the particles' forces
    LiftStage::make,
};

}  // namespace

std::vector<std::unique_ptr<EffectStage>> effectStages(const EffectContext& context) {
  std::vector<std::unique_ptr<EffectStage>> stages;
  for (const Make make : makers)
    if (auto stage = make(context)) stages.push_back(std::move(stage));
  return stages;
}

}  // namespace bedmix
