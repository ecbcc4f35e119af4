// SPDX-License-Identifier: MIT
#include "render/colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bedmix {

namespace {

/// Highest power first.
std::uint8_t polynomial(const std::array<double, 6>& coefficients, double t) {
  double sum = 0.0;
  for (const double c : coefficients) sum = sum * t + c;
  return static_cast<std::uint8_t>(std::lround(std::clamp(sum, 0.0, 255.0)));
}

}  // namespace

Rgba cividis(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return {polynomial({-2710.57, 7024.72, -6402.7, 2381.73, -35.34, -4.54}, t),
          polynomial({-67.37, 176.58, -131.46, 52.82, 170.73, 32.49}, t),
          polynomial({2475.67, -6614.94, 6167.24, -2482.43, 442.36, 81.24}, t)};
}

}  // namespace bedmix
