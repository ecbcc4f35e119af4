// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// What integrators share. Their loops over particles run along one axis at a time and are functions of
// pointers, because g++ heeds __restrict best in arguments.

namespace bedmix {

/// m/s2 along one axis.
struct Acceleration {
  double perMass;  // 1/kg
  double gravity;  // m/s2

  double operator()(double contacts, double others) const { return (contacts + others) * perMass + gravity; }
};

/// Length of the longest of some vectors, 0 without any. Four at a time: one maximum would wait for the
/// other.
inline double largestNorm(const std::vector<double>& x, const std::vector<double>& y) {
  constexpr std::size_t lanes = 4;
  double largest[lanes] = {};  // squares
  const std::size_t whole = x.size() - x.size() % lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
    for (std::size_t l = 0; l < lanes; ++l)
      largest[l] = std::max(largest[l], x[i + l] * x[i + l] + y[i + l] * y[i + l]);
  for (std::size_t i = whole; i < x.size(); ++i) largest[0] = std::max(largest[0], x[i] * x[i] + y[i] * y[i]);
  return std::sqrt(std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3])));
}

}  // namespace bedmix
