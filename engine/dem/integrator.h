// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/bed_state.h"

#include <cstdint>

// Each integrator has begin(), called once before the first step, of a finite bed, or goOn(), called in its
// place where the bed was loaded, advance(), and relist(), called where particles have come or gone since.
// Positions, velocities and histories belong to the same
// instant after any of them.

namespace bedmix {

/// How far advance() came.
struct StepOutcome {
  std::int64_t steps = 0;  // taken
  bool finite = true;  // else the bed has to be looked at: something no longer is, or moves too fast for it
};

/// The deepest overlap so far of all blocks, m.
double deepestOverlap(const BedState& bed);

}  // namespace bedmix
