// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/thread_team.h"

#include <algorithm>
#include <cstddef>

namespace bedmix {

/// Into how many blocks of neighbours loops over `n` particles are cut: some thousand in each, but no more
/// than 64. Depends on nothing else, so that sums taken block by block are the same for any number of
/// threads.
constexpr std::size_t blocksOf(std::size_t n) { return std::clamp<std::size_t>(n / 1024, 1, 64); }

/// Who is in one of the `blocks` of n; all but the last are whole vectors of eight.
constexpr Range blockOf(std::size_t n, std::size_t blocks, std::size_t block) {
  const auto edge = [&](std::size_t b) { return b == blocks ? n : n * b / blocks / 8 * 8; };
  return {edge(block), edge(block + 1)};
}

}  // namespace bedmix
