// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace bedmix {

/// A few threads that share loops whose items do not depend on each other. Blocks have a fixed size, never
/// one derived from the number of threads, and whoever is free takes the next, so results cannot depend on
/// that number.
class ThreadTeam {
 public:
  /// `threads` >= 1 counts the calling thread; with 1 nothing is started and loops run in place.
  explicit ThreadTeam(int threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// Calls body(begin, end) for consecutive blocks that cover [0, n), and returns when all are done. `body`
  /// must not throw. From one thread at a time.
  void forBlocks(std::size_t n, const std::function<void(std::size_t begin, std::size_t end)>& body);

 private:
  void work();
  void takeBlocks();

  std::atomic<std::uint64_t> round_{0};  // moves when a loop begins
  std::atomic<std::size_t> next_{0};     // first item nobody has taken
  std::atomic<int> busy_{0};             // helpers that have not finished the loop
  std::atomic<bool> quit_{false};
  std::size_t n_ = 0;
  const std::function<void(std::size_t, std::size_t)>* body_ = nullptr;
  std::vector<std::jthread> helpers_;
};

}  // namespace bedmix
