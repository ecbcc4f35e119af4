// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace bedmix {

/// Which instructions the vector loops use. Results never depend on it: products and sums are never fused,
/// and what is summed over particles is summed in an order of its own.
enum class SimdLevel { baseline, avx2, avx512 };

/// The names users know them by, in the order of SimdLevel.
std::span<const std::string_view> simdLevelNames();
std::optional<SimdLevel> simdLevelNamed(std::string_view name);

/// The best this machine has; it has all below it as well.
SimdLevel bestSimdLevel();
/// The names of those it has.
std::span<const std::string_view> simdLevelsHere();
/// In use: the best one unless told otherwise.
SimdLevel simdLevel();
/// From the next vector loop on; for all threads, so not while a simulation advances. False, and nothing is
/// changed, where this machine lacks it.
bool useSimdLevel(SimdLevel level);

}  // namespace bedmix
