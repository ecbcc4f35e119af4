// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

namespace bedmix {

/// A mean and the half width of its confidence interval.
struct Estimate {
  double mean = 0.0;
  double halfWidth = 0.0;
  int count = 0;

  bool differsFromZero() const { return mean > halfWidth || mean < -halfWidth; }
};

/// Chance that an interval misses the truth; less where several are looked at together (Bonferroni).
inline constexpr double usualRisk = 0.05;

/// Of independent values, by Student's t. Empty with fewer than three.
std::optional<Estimate> estimate(std::span<const double> values, double risk = usualRisk);

/// Mean of `a` minus that of `b`, by Welch's t (1947, Biometrika 34:28). Empty where either has fewer than
/// three.
std::optional<Estimate> difference(std::span<const double> a, std::span<const double> b,
                                   double risk = usualRisk);

/// The value that Student's t of so many degrees of freedom (2 or more) exceeds in magnitude with the chance
/// `risk`.
double studentQuantile(double degreesOfFreedom, double risk);

double median(std::span<const double> values);  // at least one

}  // namespace bedmix
