// SPDX-License-Identifier: MIT
#include "render/band.h"

#include "engine/core/quantile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bedmix {

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
