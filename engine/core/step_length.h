// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace bedmix {

/// The length of a time step, s; or none where the simulation chooses it as it goes, "auto" in a scene.
class StepLength {
 public:
  StepLength(double seconds) : seconds_(seconds) {}  // NOLINT: a number is one
  static StepLength automatic() { return StepLength(); }

  bool isAutomatic() const { return !seconds_; }
  /// Only of one that is given.
  operator double() const { return seconds_.value(); }  // NOLINT: one is a number
  double valueOr(double seconds) const { return seconds_.value_or(seconds); }

 private:
  StepLength() = default;
  std::optional<double> seconds_;
};

/// What an automatic one is called in a scene.
inline constexpr const char* automaticStep = "auto";

}  // namespace bedmix
