// SPDX-License-Identifier: MIT
#include "app/interrupt.h"

#include <csignal>

namespace bedmix {

namespace {

volatile std::sig_atomic_t stop = 0, checkpoint = 0;

extern "C" void noteStop(int) { stop = 1; }
extern "C" void noteCheckpoint(int) { checkpoint = 1; }

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

bool stopRequested() { return stop != 0; }

bool checkpointRequested() {
  const bool requested = checkpoint != 0;
  checkpoint = 0;
  return requested;
}

}  // namespace bedmix
