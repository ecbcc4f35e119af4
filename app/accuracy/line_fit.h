// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace bedmix {

/// y = intercept + slope x by least squares; at least two different x.
struct LineFit {
  double slope = 0.0, intercept = 0.0;
  double slopeError = 0.0;  // standard error; 0 with two points
};
LineFit fitLine(std::span<const double> x, std::span<const double> y);

/// The order p of error = C step^p, by least squares in logarithms.
struct Order {
  double value = 0.0;
  double uncertainty = 0.0;  // standard error
  int points = 0;
};
/// Over the points whose error is finite, above `floor` and below `ceiling`: what lies outside is rounding
/// or no longer small. Empty with fewer than three.
std::optional<Order> fitOrder(std::span<const double> steps, std::span<const double> errors, double floor,
                              double ceiling);

/// Indices of those that no other beats in both: no more costly and less in error, or cheaper and no more in
/// error; by cost. What is not finite is not among them.
std::vector<std::size_t> paretoFront(std::span<const double> costs, std::span<const double> errors);

}  // namespace bedmix
