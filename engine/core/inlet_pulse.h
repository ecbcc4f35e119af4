// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/models.h"

#include <vector>

namespace bedmix {

/// What comes in goes up and down around its mean.
struct PulseSettings {
  PulseShape shape = PulseShape::sine;
  double frequency = 4.0;  // Hz
  double amplitude = 1.0;  // of the mean
  double duty = 0.5;       // of a square one: share of a period that it is on
  double phase = 0.0;      // periods that have gone by at t = 0
};

/// One point of a line that an inlet's velocity follows.
struct SchedulePoint {
  double time = 0.0;    // s
  double factor = 1.0;  // on the inlet's velocity
};

/// Mean over [from, from + length], s, of a pulse over its own mean: a sine 1 + a sin(2 pi c); a square one
/// 1 - a when it is off and 1 + a (1 - duty)/duty for the first `duty` of each period; c = f t + phase. The
/// same bits on every machine.
double meanOf(const PulseSettings& pulse, double from, double length);
/// The largest that it ever is.
double largestOf(const PulseSettings& pulse);

/// The line at a time, s; before its first and after its last point it stays what it is there. 1 where there
/// are no points. The points' times must ascend.
double factorAt(const std::vector<SchedulePoint>& schedule, double time);
double largestOf(const std::vector<SchedulePoint>& schedule);

}  // namespace bedmix
