// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace bedmix {

/// Calls `use(i, j)` for each particle that is in both frames, i its row in the one and j in the other. Rows
/// are in the order of ids, as a Frame's are; particles may have come and gone between the two.
template <class Use>
void forParticlesInBoth(std::span<const std::int32_t> a, std::span<const std::int32_t> b, const Use& use) {
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i] == b[j]) use(i, j);
    const bool step = a[i] <= b[j];
    j += b[j] <= a[i];
    i += step;
  }
}

}  // namespace bedmix
