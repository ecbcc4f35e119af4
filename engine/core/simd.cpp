// SPDX-License-Identifier: MIT
#include "engine/core/simd.h"

#include <algorithm>
#include <array>
#include <hwy/highway.h>

namespace bedmix {

namespace {

constexpr std::array<std::string_view, 3> names{"baseline", "avx2", "avx512"};

#if HWY_ARCH_X86
/// The lowest bit is the best target, as Highway numbers them.
SimdLevel best(std::int64_t targets) {
  if (targets & HWY_AVX3) return SimdLevel::avx512;
  if (targets & HWY_AVX2) return SimdLevel::avx2;
  return SimdLevel::baseline;
}
std::int64_t targetsAbove(SimdLevel level) {
  switch (level) {
    case SimdLevel::baseline:
      return HWY_AVX2 | HWY_AVX3;
    case SimdLevel::avx2:
      return HWY_AVX3;
    case SimdLevel::avx512:
      break;
  }
  return 0;
}
#else
SimdLevel best(std::int64_t) { return SimdLevel::baseline; }
std::int64_t targetsAbove(SimdLevel) { return 0; }
#endif

}  // namespace

std::span<const std::string_view> simdLevelNames() { return names; }

std::optional<SimdLevel> simdLevelNamed(std::string_view name) {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) return std::nullopt;
  return static_cast<SimdLevel>(at - names.begin());
}

SimdLevel simdLevel() { return best(hwy::SupportedTargets()); }

SimdLevel bestSimdLevel() {
  static const SimdLevel level = simdLevel();  // before the first restriction, see useSimdLevel()
  return level;
}

std::span<const std::string_view> simdLevelsHere() {
  return simdLevelNames().first(static_cast<std::size_t>(bestSimdLevel()) + 1);
}

bool useSimdLevel(SimdLevel level) {
  if (level > bestSimdLevel()) return false;
  hwy::DisableTargets(targetsAbove(level));
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return true;
}

}  // namespace bedmix
