// SPDX-License-Identifier: MIT
#include "engine/core/thread_team.h"

#include <algorithm>
#if defined(__x86_64__)
#include <immintrin.h>
#endif
#include <sched.h>

namespace bedmix {

namespace {

/// Busy looks before a member goes to sleep: some 100 us, longer than what one of them does alone between two
/// loops of a small bed. Waking a sleeper takes as long.
constexpr int longSpins = 3000;

void pause() {
#if defined(__x86_64__)
  _mm_pause();
#endif
}

void waitWhile(const std::atomic<std::uint32_t>& value, std::uint32_t old, int spins) {
  for (int i = 0; i < spins; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
    pause();
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

int availableCores() {
  cpu_set_t mine;
  if (sched_getaffinity(0, sizeof mine, &mine) == 0) return CPU_COUNT(&mine);
  return std::max(1,
                  static_cast<int>(std::thread::hardware_concurrency()));  // more cores than cpu_set_t holds
}

ThreadTeam& oneThread() {
  static ThreadTeam team(1);
  return team;
}

ThreadTeam::ThreadTeam(int threads) {
  // Where cores are fewer than members, whoever spins keeps the others from working.
  const bool crowded = threads > availableCores();
  spins_ = crowded ? 0 : longSpins;
  absent_ = threads;
  for (int member = 1; member < threads; ++member) helpers_.emplace_back([this, member] { work(member); });
}

ThreadTeam::~ThreadTeam() {
  quit_ = true;
  ++round_;
  round_.notify_all();
}

void ThreadTeam::work(int member) {
  for (std::uint32_t seen = 0;;) {
    waitWhile(round_, seen, spins_);
    ++seen;
    if (quit_) return;
    call_(body_, member);
    meet();
  }
}

void ThreadTeam::runTogether() {
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  call_(body_, 0);
  meet();
}

void ThreadTeam::meet() {
  const std::uint32_t now = meeting_.load(std::memory_order_acquire);
  if (absent_.fetch_sub(1, std::memory_order_acq_rel) == 1) {
    absent_.store(size(), std::memory_order_relaxed);
    meeting_.fetch_add(1, std::memory_order_release);
    meeting_.notify_all();
  } else {
    waitWhile(meeting_, now, spins_);
  }
}

}  // namespace bedmix
