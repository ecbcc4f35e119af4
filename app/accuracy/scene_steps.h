// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace bedmix {

/// Ticks in so many seconds, at least one.
inline std::int64_t ticksIn(const Scene& scene, double seconds) {
  return std::max<std::int64_t>(1, std::llround(seconds / tick(scene)));
}

/// The longest step that particles take, s.
inline double longestTaken(const Scene& scene) {
  if (scene.time.step.isAutomatic()) return longestStep(scene);
  return scene.time.step;
}

}  // namespace bedmix
