// SPDX-License-Identifier: MIT
#include "engine/core/index_band.h"

#include "engine/core/quantile.h"
#include "engine/core/rng.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bedmix {

namespace {

/// ln S^2 of values and its standard error, from var(S^2) = (mu_4 - sigma^4 (K-3)/(K-1))/K.
struct LogVariance {
  double value = 0.0, error = 0.0;
};
std::optional<LogVariance> logVariance(const std::vector<double>& values) {
  const double k = static_cast<double>(values.size());
  double mean = 0.0, second = 0.0, fourth = 0.0;
  for (double v : values) mean += v;
  mean /= k;
  for (double v : values) {
    const double square = (v - mean) * (v - mean);
    second += square / k;
    fourth += square * square / k;
  }
  if (!(second > 0.0)) return std::nullopt;
  const double kurtosis = fourth / (second * second);
  return LogVariance{std::log(second * k / (k - 1.0)), std::sqrt((kurtosis - (k - 3.0) / (k - 1.0)) / k)};
}

}  // namespace

MixingBand mixingBand(const CellCounts& counts, int minParticles, std::uint64_t seed) {
  const CellStatistics cells = cellStatistics(counts, minParticles);
  if (!cells.defined() || cells.cells < fewestBandCells) return {};
  std::vector<double> fractions;
  for (std::size_t c = 0; c < counts.all.size(); ++c)
    if (counts.all[c] >= minParticles)
      fractions.push_back(static_cast<double>(counts.tracer[c]) / counts.all[c]);
  const auto measured = logVariance(fractions);
  if (!measured) return {};

  Rng rng(seed);
  std::vector<double> drawn(fractions.size()), student;
  for (int r = 0; r < bandResamples; ++r) {
    for (double& v : drawn) v = fractions[rng.next() % fractions.size()];
    if (const auto other = logVariance(drawn))
      student.push_back((other->value - measured->value) / other->error);
  }
  if (student.empty()) return {};
  std::sort(student.begin(), student.end());

  const auto with = [&](double share) {
    CellStatistics other = cells;
    // No fractions of that mean have more than this variance.
    const double most = cells.segregated * cells.cells / (cells.cells - 1.0);
    other.variance = std::min(std::exp(measured->value - quantile(student, share) * measured->error), most);
    return other;
  };
  const CellStatistics apart = with(0.025), mixed = with(0.975);
  return {{laceyIndex(apart), laceyIndex(mixed)}, {ashtonIndex(apart), ashtonIndex(mixed)}};
}

}  // namespace bedmix
