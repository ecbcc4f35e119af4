// SPDX-License-Identifier: MIT
#include "app/interrupt.h"

#include <atomic>
#include <csignal>

namespace bedmix {

namespace {

// Any thread may be the one that a signal interrupts.
std::atomic<bool> stop = false, checkpoint = false;
static_assert(std::atomic<bool>::is_always_lock_free, "signal handlers may write nothing else");

extern "C" void noteStop(int) { stop = true; }
extern "C" void noteCheckpoint(int) { checkpoint = true; }

}  // namespace

void catchInterrupts() {
  struct sigaction action {};
  action.sa_handler = noteStop;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  action.sa_handler = noteCheckpoint;
  action.sa_flags = SA_RESTART;
  sigaction(SIGUSR1, &action, nullptr);
}

bool stopRequested() { return stop; }

bool checkpointRequested() { return checkpoint.exchange(false); }

}  // namespace bedmix
