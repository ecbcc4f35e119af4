// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace bedmix {

/// The newest frame of each bed.
class LastFrames {
 public:
  explicit LastFrames(std::size_t beds) : frames_(beds), seen_(beds) {}

  void keep(std::size_t bed, const Frame& frame) {
    frames_[bed] = frame;
    seen_[bed] = &frames_[bed];
  }
  /// Null for beds of which none was kept.
  const std::vector<const Frame*>& frames() const { return seen_; }
  bool areComplete() const { return std::find(seen_.begin(), seen_.end(), nullptr) == seen_.end(); }

 private:
  std::vector<Frame> frames_;
  std::vector<const Frame*> seen_;
};

}  // namespace bedmix
