// SPDX-License-Identifier: MIT
#include "engine/core/start_correlation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bedmix {

StartCorrelation::StartCorrelation(const Frame& start) {
  if (start.id.size() != start.size()) return;
  for (std::size_t i = 0; i < start.size(); ++i) start_.emplace_back(start.id[i], start.position[i]);
  std::sort(start_.begin(), start_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
}

std::optional<StartCorrelation::PrincipalComponent> StartCorrelation::with(const Frame& frame) const {
  if (frame.id.size() != frame.size()) return std::nullopt;
  std::vector<std::array<double, 4>> pairs;  // x, y now, x, y at the start
  pairs.reserve(frame.size());
  std::array<double, 4> mean{};
  for (std::size_t i = 0; i < frame.size(); ++i) {
    // As a rule all particles stay, in the order of their ids.
    auto at = start_.begin() + static_cast<std::ptrdiff_t>(std::min(i, start_.size()));
    if (at == start_.end() || at->first != frame.id[i])
      at = std::lower_bound(start_.begin(), start_.end(), frame.id[i],
                            [](const auto& entry, std::int32_t id) { return entry.first < id; });
    if (at == start_.end() || at->first != frame.id[i]) continue;
    pairs.push_back({frame.position[i].x, frame.position[i].y, at->second.x, at->second.y});
    for (std::size_t a = 0; a < 4; ++a) mean[a] += pairs.back()[a];
  }
  for (double& m : mean) m /= static_cast<double>(pairs.size());

  std::array<std::array<double, 4>, 4> sums{};
  for (const auto& pair : pairs)
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a; b < 4; ++b) sums[a][b] += (pair[a] - mean[a]) * (pair[b] - mean[b]);
  for (std::size_t a = 0; a < 4; ++a)
    if (!(sums[a][a] > 0.0)) return std::nullopt;
  const auto correlation = [&sums](std::size_t a, std::size_t b) {
    return sums[a][b] / std::sqrt(sums[a][a] * sums[b][b]);
  };

  // C^T C = [[xx, xy], [xy, yy]]; at the start C = [[1, r], [r, 1]], whose square has the eigenvalue (1 +
  // |r|)^2.
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const std::size_t now : {0u, 1u}) {
    const double x = correlation(now, 2), y = correlation(now, 3);
    xx += x * x, xy += x * y, yy += y * y;
  }
  const double largest = 0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy);
  const double atStart = 1.0 + std::abs(correlation(2, 3));
  return PrincipalComponent{largest / (atStart * atStart), 0.5 * std::atan2(2.0 * xy, xx - yy)};
}

}  // namespace bedmix
