// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <type_traits>
#include <vector>

namespace bedmix {

/// The cores this process may use: those of the machine, or fewer where it is bound to some of them.
int availableCores();

/// Part [begin, end) of a loop.
struct Range {
  std::size_t begin = 0, end = 0;
  std::size_t size() const { return end - begin; }
};

/// A few threads that work through the same code together. What they share out must not depend on how many
/// they are: blocks are cut by the size of the data, and sums over blocks are taken in the blocks' order.
class ThreadTeam {
 public:
  /// `threads` >= 1 counts the calling thread; with 1 nothing is started and everything runs in place.
  explicit ThreadTeam(int threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int size() const { return static_cast<int>(helpers_.size()) + 1; }

  /// Every member calls body(member), 0 <= member < size(), the caller as member 0; returns when all are
  /// done. `body` must not throw. From one thread at a time, and not within run().
  template <class Body>
  void run(Body&& body) {
    if (helpers_.empty()) return body(0);
    using Plain = std::remove_reference_t<Body>;
    call_ = [](void* b, int member) { (*static_cast<Plain*>(b))(member); };
    body_ = const_cast<void*>(static_cast<const void*>(&body));
    runTogether();
  }

  /// Within run(): waits until every member has come here. What members wrote before, all see after.
  void barrier() {
    if (!helpers_.empty()) meet();
  }

  /// A member's part of `n` items, next to those of the members beside it.
  Range share(std::size_t n, int member) const {
    const auto m = static_cast<std::size_t>(member), all = static_cast<std::size_t>(size());
    return {n * m / all, n * (m + 1) / all};
  }

 private:
  void runTogether();
  void meet();
  void work(int member);

  int spins_ = 0;
  std::atomic<std::uint32_t> round_{0};    // moves when run() begins
  std::atomic<std::uint32_t> meeting_{0};  // moves when all have met
  std::atomic<int> absent_{0};             // members that have not come to the meeting
  std::atomic<bool> quit_{false};
  void (*call_)(void*, int) = nullptr;
  void* body_ = nullptr;
  std::vector<std::jthread> helpers_;
};

/// The calling thread alone: for whoever has no team. May be used from several threads at a time.
ThreadTeam& oneThread();

}  // namespace bedmix
