// SPDX-License-Identifier: MIT
#include "replay/frame_pool.h"

#include <atomic>

namespace bedmix {

namespace {

constexpr std::size_t mostKept = 3;  // one in use, the one before it, and one to be filled

}  // namespace

std::shared_ptr<Frame> FramePool::take() {
  for (const std::shared_ptr<Frame>& frame : kept_) {
    if (frame.use_count() > 1) continue;
    std::atomic_thread_fence(std::memory_order_acquire);  // whoever let go of it has read it
    return frame;
  }
  auto frame = std::make_shared<Frame>();
  if (kept_.size() < mostKept) kept_.push_back(frame);
  return frame;
}

}  // namespace bedmix
