// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/contact_law.h"
#include "engine/dem/rows.h"

#include <cstddef>
#include <cstdint>

namespace bedmix {

/// Pairs of places in memory, each pair `stride` after the last.
struct PairPlaces {
  const std::int32_t* first;
  const std::int32_t* second;
  std::size_t stride, count;
};

/// The square of the hardest impact of some pairs, (m/s)2, in vectors: of those that touch that of the speed
/// with which they met, closing^2 + (w overlap)^2, of those that meet within `span` (s) that of their closing
/// speed; 0 without any. Right to the second order of overlaps and gaps over the diameter.
double hardestImpact2(const SpringDashpot& law, double span, const Body* body, const PairPlaces& pairs);

}  // namespace bedmix
