// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace bedmix {

/// Particles are worked through in batches that stay in the nearest cache, with one array a quantity.
inline constexpr std::size_t batchSize = 64;

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

/// What the upper one of two points along one axis has of a particle.
struct AxisShares {
  alignas(64) double volume[batchSize];  // of the particle's, in the cell
  alignas(64) double centre[batchSize];  // of the weight in an interpolation between cell centres
  alignas(64) double face[batchSize];    // and between faces
};

struct BatchShares {
  AxisShares x, y;
  alignas(64) double coupled[batchSize];  // share of the particle
};

}  // namespace bedmix
