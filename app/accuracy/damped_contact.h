// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

namespace bedmix {

/// A contact of the linear spring and dashpot in closed form: overlap and its rate from touch at t = 0 with
/// closing speed 1 m/s until it is zero again. `mass` is the reduced one.
struct DampedContact {
  double mass, stiffness, damping;  // kg, N/m, kg/s

  bool rebounds() const { return damping < 2.0 * std::sqrt(stiffness * mass); }
  double decay() const { return damping / (2.0 * mass); }
  double frequency() const { return std::sqrt(stiffness / mass - decay() * decay()); }
  double duration() const { return std::numbers::pi / frequency(); }
  double overlap(double t) const { return std::exp(-decay() * t) * std::sin(frequency() * t) / frequency(); }
  double rate(double t) const {
    return std::exp(-decay() * t) *
           (std::cos(frequency() * t) - decay() / frequency() * std::sin(frequency() * t));
  }
  double restitution() const { return -rate(duration()); }
  /// Integral of |F_n| over the contact, N s: at its very end, when the rebound is fastest, the dashpot
  /// begins to pull.
  double grossImpulse() const {
    const double a = decay(), w = frequency();
    const double pullsFrom = (std::numbers::pi - std::atan2(2.0 * a * w, w * w - a * a)) / w;
    return mass * (1.0 - restitution() - 2.0 * rate(pullsFrom));
  }
};

}  // namespace bedmix
