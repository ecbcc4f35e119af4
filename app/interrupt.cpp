// SPDX-License-Identifier: MIT
#include "app/interrupt.h"

#include <csignal>

namespace bedmix {

namespace {

volatile std::sig_atomic_t requested = 0;

extern "C" void noteSignal(int) { requested = 1; }

}  // namespace

void catchInterrupts() {
  struct sigaction action {};
  action.sa_handler = noteSignal;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool stopRequested() { return requested != 0; }

}  // namespace bedmix
