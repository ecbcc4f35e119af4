// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// A run whose solution became invalid may go on from a checkpoint with shorter steps. Where steps are
// halved, everything that is counted in steps counts twice as many; what lies between two frames, and the
// time of each, stay the same.

namespace bedmix {

/// An eighth of the step: contacts that a step of T/14 just resolves are resolved by T/112 then, finer than
/// in the paper. What still fails does not fail for its step, and the run would take eight times as long.
inline constexpr std::int64_t mostHalvings = 3;

/// The scene with its steps halved that much further; of automatic ones the allowed error is divided.
Scene refined(Scene scene, Refinement further);
/// The scene as it was asked for.
Scene unrefined(Scene scene);

/// Path and value of each setting that a refinement changes, as the scene has them.
using RefinedSettings = std::vector<std::pair<std::string, double>>;
RefinedSettings refinedSettings(const Scene& scene);

/// How many ticks of one scene make a tick of the other, which differs in fewer halvings alone.
std::int64_t stepsPerStep(const Scene& fine, const Scene& coarse);

}  // namespace bedmix
