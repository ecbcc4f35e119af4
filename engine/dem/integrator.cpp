// SPDX-License-Identifier: MIT
#include "engine/dem/integrator.h"

#include <algorithm>

namespace bedmix {

double deepestOverlap(const BedState& bed) {
  double deepest = 0.0;
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b)
    deepest = std::max(deepest, bed.contacts.block(b).deepest);
  return deepest;
}

}  // namespace bedmix
