// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/neighbours.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace bedmix {

/// What contacts remember from one evaluation of the forces to the next. Candidates are numbered pairs first,
/// then walls, in the order of the neighbour list.
struct ContactHistory {
  bool hasSprings = false;     // only with friction
  std::vector<double> spring;  // m, along t = (-n_y, n_x); 0 for who does not touch; empty without springs
  std::vector<double> slip;    // m/s, at the last evaluation; likewise
  std::vector<std::int32_t> touching;  // candidates that touch, ascending; the first `count` are valid
  std::size_t pairCount = 0;           // of them between particles
  std::size_t count = 0;               // all

  std::span<const std::int32_t> pairContacts() const { return {touching.data(), pairCount}; }
  std::span<const std::int32_t> wallContacts() const {
    return {touching.data() + pairCount, count - pairCount};
  }

  /// No contact at all, room for `candidates`.
  void reset(std::size_t candidates, bool withSprings);
  /// No contact at all, the room as it is. Costs what the contacts are, not the candidates.
  void clear();
  /// Moves every contact to its place in the list just built. `spare` lends its memory and ends up reset.
  void carryOver(const NeighbourList& list, ContactHistory& spare);
};

}  // namespace bedmix
