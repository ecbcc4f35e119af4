// SPDX-License-Identifier: MIT
#include "engine/core/thread_team.h"

#include <algorithm>

namespace bedmix {

namespace {

constexpr std::size_t blockSize =
    256;  // particles; some 10 us of drag, well above the cost of taking a block
/// Items below which waking the helpers costs more than they save: measured on the drag of a 1,000-particle
/// bed, which two threads made slower, and of 20,000, which they made faster.
constexpr std::size_t worthSharing = 8192;
constexpr int spins = 20000;  // some 50 us: longer than the pause between two loops of a small bed

/// Waits until `value` is no longer `old`: at first busily, since loops follow each other closely, then
/// asleep.
template <class T>
void waitWhile(const std::atomic<T>& value, T old) {
  for (int i = 0; i < spins; ++i)
    if (value.load(std::memory_order_acquire) != old) return;
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

ThreadTeam::ThreadTeam(int threads) {
  for (int i = 1; i < threads; ++i) helpers_.emplace_back([this] { work(); });
}

ThreadTeam::~ThreadTeam() {
  quit_ = true;
  ++round_;
  round_.notify_all();
}

void ThreadTeam::takeBlocks() {
  for (;;) {
    const std::size_t begin = next_.fetch_add(blockSize, std::memory_order_relaxed);
    if (begin >= n_) return;
    (*body_)(begin, std::min(begin + blockSize, n_));
  }
}

void ThreadTeam::work() {
  for (std::uint64_t seen = 0;;) {
    waitWhile(round_, seen);
    ++seen;
    if (quit_) return;
    takeBlocks();
    if (busy_.fetch_sub(1, std::memory_order_release) == 1) busy_.notify_one();
  }
}

void ThreadTeam::forBlocks(std::size_t n, const std::function<void(std::size_t, std::size_t)>& body) {
  if (helpers_.empty() || n < worthSharing) {
    if (n > 0) body(0, n);
    return;
  }
  n_ = n;
  body_ = &body;
  next_.store(0, std::memory_order_relaxed);
  busy_.store(static_cast<int>(helpers_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  takeBlocks();
  for (int left = busy_.load(std::memory_order_acquire); left != 0;
       left = busy_.load(std::memory_order_acquire))
    waitWhile(busy_, left);
}

}  // namespace bedmix
