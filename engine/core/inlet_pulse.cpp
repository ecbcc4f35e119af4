// SPDX-License-Identifier: MIT
#include "engine/core/inlet_pulse.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bedmix {

namespace {

using std::numbers::pi;

/// sin(2 pi turns) to 1e-15, of sums and products alone: library functions differ in the last bits.
double sineOf(double turns) {
  double t = turns - std::round(turns);  // -1/2 to 1/2
  if (std::abs(t) > 0.25) t = std::copysign(0.5, t) - t;
  const double x = 2.0 * pi * t, square = x * x;
  double sum = 1.0;
  for (int k = 22; k > 0; k -= 2) sum = 1.0 - square / (k * (k + 1.0)) * sum;
  return x * sum;
}

/// Time, in periods, that a square pulse has been on since period 0.
double onUntil(double periods, double duty) {
  const double whole = std::floor(periods);
  return whole * duty + std::min(periods - whole, duty);
}

}  // namespace

double meanOf(const PulseSettings& pulse, double from, double length) {
  const double begin = pulse.frequency * from + pulse.phase, periods = pulse.frequency * length;
  if (pulse.shape == PulseShape::sine) {
    // The mean of a sine over a stretch is the sine of its middle times sin(x)/x of half of it.
    const double half = 0.5 * periods, x = 2.0 * pi * half;
    const double flattened = x > 1e-9 ? sineOf(half) / x : 1.0;
    return 1.0 + pulse.amplitude * flattened * sineOf(begin + half);
  }
  const double on = (onUntil(begin + periods, pulse.duty) - onUntil(begin, pulse.duty)) / periods;
  const double off = 1.0 - pulse.amplitude;
  return off + std::clamp(on, 0.0, 1.0) * (largestOf(pulse) - off);
}

double largestOf(const PulseSettings& pulse) {
  if (pulse.shape == PulseShape::sine) return 1.0 + pulse.amplitude;
  return 1.0 + pulse.amplitude * (1.0 - pulse.duty) / pulse.duty;
}

double factorAt(const std::vector<SchedulePoint>& schedule, double time) {
  if (schedule.empty()) return 1.0;
  const auto next = std::find_if(schedule.begin(), schedule.end(),
                                 [time](const SchedulePoint& point) { return point.time > time; });
  if (next == schedule.begin()) return next->factor;
  const SchedulePoint& before = *(next - 1);
  if (next == schedule.end()) return before.factor;
  return before.factor + (next->factor - before.factor) * (time - before.time) / (next->time - before.time);
}

double largestOf(const std::vector<SchedulePoint>& schedule) {
  double largest = schedule.empty() ? 1.0 : 0.0;
  for (const SchedulePoint& point : schedule) largest = std::max(largest, point.factor);
  return largest;
}

}  // namespace bedmix
