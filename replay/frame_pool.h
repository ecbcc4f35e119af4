// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"

#include <memory>
#include <vector>

namespace bedmix {

/// Frames whose memory is used again once nobody holds them: fresh pages for each frame of a large bed cost
/// more than reading it. Hands out from one thread; frames may be let go of by any.
class FramePool {
 public:
  /// One that nobody else holds, with what it held before, or a new one.
  std::shared_ptr<Frame> take();

 private:
  std::vector<std::shared_ptr<Frame>> kept_;
};

}  // namespace bedmix
