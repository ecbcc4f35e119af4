// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/contact_history.h"
#include "engine/dem/contacts.h"
#include "engine/dem/neighbours.h"
#include "engine/dem/particles.h"

#include <chrono>

namespace bedmix {

/// Wall seconds by stage.
struct DemSeconds {
  double neighbours = 0.0;
  double contacts = 0.0;
  double integrate = 0.0;
};

/// Adds the time since the last lap to a stage.
class LapTimer {
 public:
  void lap(double& stage) {
    const Clock::time_point now = Clock::now();
    stage += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

/// What integrators advance.
struct BedState {
  Particles particles;
  NeighbourList neighbours;
  ContactHistory history;
  ContactLoads loads;  // at the last evaluation
  double gravity;      // m/s2, downward
  double step;         // s
  DemSeconds seconds;
};

}  // namespace bedmix
