// SPDX-License-Identifier: MIT
#include "app/accuracy/interval.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace bedmix {

namespace {

constexpr std::size_t fewest = 3;
constexpr double nearlyNormal = 1000.0;  // degrees of freedom from which on quantiles differ by 0.2 %

struct Moments {
  double mean = 0.0;
  double squaredError = 0.0;  // variance of the mean
  double degrees = 0.0;
};

Moments momentsOf(std::span<const double> values) {
  const double n = static_cast<double>(values.size());
  Moments m{0.0, 0.0, n - 1.0};
  for (const double v : values) m.mean += v / n;
  for (const double v : values) m.squaredError += (v - m.mean) * (v - m.mean) / (n - 1.0) / n;
  return m;
}

}  // namespace

// With t = sqrt(n) tan(angle) the density becomes cos^(n-1)(angle), of which only shares are needed.
double studentQuantile(double degreesOfFreedom, double risk) {
  const double degrees = std::min(degreesOfFreedom, nearlyNormal);
  const auto density = [&](double angle) { return std::pow(std::cos(angle), degrees - 1.0); };
  const auto integral = [&](double to) {  // Simpson's rule
    constexpr int halves = 200;
    const double h = to / (2 * halves);
    double sum = density(0.0) + density(to);
    for (int i = 1; i < 2 * halves; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * density(i * h);
    return sum * h / 3.0;
  };
  const double all = integral(0.5 * std::numbers::pi);
  double low = 0.0, high = 0.5 * std::numbers::pi;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (integral(middle) < (1.0 - risk) * all ? low : high) = middle;
  }
  return std::sqrt(degrees) * std::tan(low);
}

std::optional<Estimate> estimate(std::span<const double> values, double risk) {
  if (values.size() < fewest) return std::nullopt;
  const Moments m = momentsOf(values);
  return Estimate{m.mean, studentQuantile(m.degrees, risk) * std::sqrt(m.squaredError),
                  static_cast<int>(values.size())};
}

std::optional<Estimate> difference(std::span<const double> a, std::span<const double> b, double risk) {
  if (a.size() < fewest || b.size() < fewest) return std::nullopt;
  const Moments ma = momentsOf(a), mb = momentsOf(b);
  const double squared = ma.squaredError + mb.squaredError;
  const double spread =
      ma.squaredError * ma.squaredError / ma.degrees + mb.squaredError * mb.squaredError / mb.degrees;
  const double degrees = spread > 0.0 ? squared * squared / spread : ma.degrees + mb.degrees;
  return Estimate{ma.mean - mb.mean, studentQuantile(degrees, risk) * std::sqrt(squared),
                  static_cast<int>(std::min(a.size(), b.size()))};
}

double median(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t n = sorted.size();
  return 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]);
}

}  // namespace bedmix
