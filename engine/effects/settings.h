// SPDX-License-Identifier: MIT
#pragma once

#include "engine/effects/cohesion.h"
#include "engine/effects/effect_set.h"
#include "engine/effects/feed_settings.h"
#include "engine/effects/heat_settings.h"
#include "engine/effects/lift_settings.h"
#include "engine/effects/reaction_settings.h"
#include "engine/effects/virtual_mass_settings.h"

namespace bedmix {

/// The effects with a table at the top of a scene, one a line: what else there is to say of them stands in
/// effects.cpp, what they do is listed in effect_stage.cpp.
using EffectSettings = EffectSet<CohesionSettings, FeedSettings, HeatSettings, LiftSettings, ReactionSettings,
                                 VirtualMassSettings>;

}  // namespace bedmix
