// SPDX-License-Identifier: MIT
#include "render/index_curve.h"

#include <cmath>

namespace bedmix {

void IndexCurve::observe(const MixingSample& sample) {
  if (sample.time <= last_) return;
  last_ = sample.time;
  if (seen_++ % stride_ != 0) return;
  if (points_.size() == mostPoints) {
    for (std::size_t i = 0; 2 * i < points_.size(); ++i) points_[i] = points_[2 * i];
    points_.resize(mostPoints / 2);
    stride_ *= 2;
    if ((seen_ - 1) % stride_ != 0) return;
  }
  const auto value = [](const std::optional<double>& v) {
    return static_cast<float>(v.value_or(std::nan("")));
  };
  points_.push_back({static_cast<float>(sample.time), value(sample.lacey), value(sample.ashton)});
}

}  // namespace bedmix
