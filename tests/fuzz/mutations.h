// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/rng.h"

#include <cstddef>
#include <string>

namespace bedmix::fuzz {

/// Below `n`, which is above 0.
std::size_t below(std::size_t n, Rng& rng);

template <class List>
const auto& oneOf(const List& list, Rng& rng) {
  return list[below(std::size(list), rng)];
}

/// Flips a bit, overwrites a byte or eight with an extreme number, cuts, repeats, moves or removes a part.
void mutateBytes(std::string& input, Rng& rng);

/// The first part of one and the last part of the other.
std::string splice(const std::string& first, const std::string& last, Rng& rng);

}  // namespace bedmix::fuzz
