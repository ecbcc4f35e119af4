// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/core/vec2.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

/// How places repeat sideways: with the bed's width where its sides are periodic, else not at all. What
/// leaves the bed at one side then comes in at the other.
struct Period {
  double length = 0.0;     // m; 0 where nothing repeats
  double perLength = 0.0;  // 1/m, likewise

  Period() = default;
  explicit Period(const Scene& scene) {
    if (scene.bed.sides != BedSides::periodic) return;
    length = scene.bed.width;
    perLength = 1.0 / length;
  }

  bool isOn() const { return length > 0.0; }
  /// How far apart two places are, by the nearest of their images; as it is where nothing repeats.
  Vec2 nearest(Vec2 apart) const { return {apart.x - length * std::nearbyint(apart.x * perLength), apart.y}; }
  /// Where who was at `from` has come to, if `to` is where it then stands in the bed.
  Vec2f next(Vec2f from, Vec2f to) const {
    return isOn() ? toFloat(toDouble(from) + nearest(toDouble(to) - toDouble(from))) : to;
  }
  /// By how much a place must be moved to lie within 0 and the length, m.
  double shiftOf(double x) const {
    if (x >= 0.0 && x < length) return 0.0;
    const double laps = std::floor(x * perLength);
    return length * (x < 0.0 ? std::max(1.0, -laps) : -std::max(1.0, laps));
  }
  /// A place in the bed in single precision, whose rounding must not take it out of the bed.
  Vec2f rounded(Vec2 at) const {
    Vec2f to = toFloat(at);
    if (!isOn()) return to;
    if (static_cast<double>(to.x) >= length) to.x = std::nextafter(to.x, 0.0f);
    to.x = std::max(to.x, 0.0f);
    return to;
  }
};

}  // namespace bedmix
