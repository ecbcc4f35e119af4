// SPDX-License-Identifier: MIT
#include "render/band.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bedmix {

namespace {

/// Of sorted values; not a number where there are none.
double quantile(const std::vector<double>& sorted, double part) {
  if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double at = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

Curve medianAndBand(std::span<const Curve> runs, std::string label) {
  std::vector<double> times;
  for (const Curve& run : runs) times.insert(times.end(), run.x.begin(), run.x.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());

  Curve curve;
  curve.label = std::move(label);
  for (const double time : times) {
    std::vector<double> values;
    bool common = true;
    for (const Curve& run : runs) {
      const auto at = std::lower_bound(run.x.begin(), run.x.end(), time);
      if (at == run.x.end()) continue;  // has ended
      if (*at != time)
        common = false;
      else if (const double y = run.y[static_cast<std::size_t>(at - run.x.begin())]; std::isfinite(y))
        values.push_back(y);
    }
    if (!common) continue;
    std::sort(values.begin(), values.end());
    curve.x.push_back(time);
    curve.y.push_back(quantile(values, 0.5));
    curve.low.push_back(quantile(values, bandLow));
    curve.high.push_back(quantile(values, bandHigh));
  }
  return curve;
}

}  // namespace bedmix
