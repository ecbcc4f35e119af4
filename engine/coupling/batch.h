// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace bedmix {

/// Particles are worked through in batches that stay in the nearest cache, with one array a quantity.
inline constexpr std::size_t batchSize = 64;

/// Calls body(i) for the items of a batch of `n`, those after each other far apart: neighbours mostly add to
/// the same sums, and each would wait for the one before.
template <class Body>
void forDistant(std::size_t n, const Body& body) {
  for (std::size_t k = 0; k < batchSize; ++k) {
    const std::size_t i = k * 19 % batchSize;
    if (i < n) body(i);
  }
}

/// How the points of a grid or of a part of it are numbered: row * stride + column - origin.
struct Numbering {
  std::int32_t stride = 0, origin = 0;
};

/// The number of a point, the last bits of a double.
inline std::int32_t pointIndex(double bits) {
  return static_cast<std::int32_t>(std::bit_cast<std::int64_t>(bits));
}

/// The lower left ones of the four points around each particle of a batch; see pointIndex().
struct PointIndices {
  alignas(64) double cell[batchSize];
  alignas(64) double uprightFace[batchSize];
  alignas(64) double levelFace[batchSize];
};

/// What the right and the upper one of two points have of each particle of a batch.
struct BatchShares {
  alignas(64) double rightVolume[batchSize], upperVolume[batchSize];  // of its volume, in cells
  /// Of the weights in an interpolation: between upright faces and between centres, one after the other, ...
  alignas(64) double right[2 * batchSize];
  alignas(64) double upperFace[batchSize],
      upperCentre[batchSize];                   // ... between level faces, between centres
  alignas(64) double coupledVolume[batchSize];  // m3
};

}  // namespace bedmix
