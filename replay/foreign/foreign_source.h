// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// Files of other programs. What they hold is taken to be in SI units. A reader of a format says what stands
// in the file; foreign_frames.h makes of it a bed in the plane.

namespace bedmix {

using Vec3d = std::array<double, 3>;

/// Particles of a file at one instant, in its own coordinates, in its own order. What the file does not say
/// is empty; what it says has as many entries as there are positions, all of them finite.
struct ForeignFrame {
  std::vector<Vec3d> position;         // m; z = 0 where the file has two dimensions
  std::vector<Vec3d> velocity;         // m/s
  std::vector<Vec3d> angularVelocity;  // rad/s
  std::vector<double> radius;          // m
  std::vector<std::int64_t> species;
  std::vector<std::int64_t> id;  // no two the same
};

/// A box, m.
struct ForeignBox {
  Vec3d low{}, high{};
};

/// Frames of a file in random access. Memory does not grow with its length, beside a few bytes a frame that
/// tell where it stands.
class ForeignSource {
 public:
  virtual ~ForeignSource() = default;

  virtual int dimensions() const = 0;  // 2 or 3
  /// What numbers the frames in the file, strictly increasing; as many as there are frames, at least one.
  virtual const std::vector<std::int64_t>& steps() const = 0;
  /// Times of the frames, s, strictly increasing; empty where the file knows none.
  virtual const std::vector<double>& times() const = 0;
  /// The box the particles are in, where the file has one.
  virtual std::optional<ForeignBox> box() const = 0;
  /// Frame `index`, below steps().size(). Fails where the file is damaged there, with file:line where it has
  /// lines.
  virtual Result<ForeignFrame> frame(std::size_t index) = 0;
};

}  // namespace bedmix
