// SPDX-License-Identifier: MIT
#include "render/colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>

namespace bedmix {

namespace {

std::uint8_t polynomial(const std::array<double, 6>& coefficients, double t) {
  double sum = 0.0;
  for (const double c : std::views::reverse(coefficients)) sum = sum * t + c;
  return static_cast<std::uint8_t>(std::lround(std::clamp(sum, 0.0, 255.0)));
}

}  // namespace

Rgba cividis(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return {polynomial({-4.54, -35.34, 2381.73, -6402.7, 7024.72, -2710.57}, t),
          polynomial({32.49, 170.73, 52.82, -131.46, 176.58, -67.37}, t),
          polynomial({81.24, 442.36, -2482.43, 6167.24, -6614.94, 2475.67}, t)};
}

}  // namespace bedmix
