// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/simulation.h"

namespace bedmix::fuzz {

/// Prints what must not be and aborts, where `holds` is false.
void require(bool holds, const char* what);

/// Requires all numbers of the frame to be finite.
void requireFinite(const Frame& frame);

/// Requires 100 more steps to leave the simulation finite, or to end with a reason.
void requireSoundSteps(Simulation& simulation);

}  // namespace bedmix::fuzz
