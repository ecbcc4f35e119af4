// SPDX-License-Identifier: MIT
#include "app/accuracy/line_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace bedmix {

LineFit fitLine(std::span<const double> x, std::span<const double> y) {
  const double n = static_cast<double>(x.size());
  const double meanX = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double meanY = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - meanX) * (x[i] - meanX);
    xy += (x[i] - meanX) * (y[i] - meanY);
  }
  LineFit fit{xy / xx, meanY - xy / xx * meanX, 0.0};
  if (x.size() < 3) return fit;
  double rest = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double r = y[i] - fit.intercept - fit.slope * x[i];
    rest += r * r;
  }
  fit.slopeError = std::sqrt(rest / (n - 2.0) / xx);
  return fit;
}

std::optional<Order> fitOrder(std::span<const double> steps, std::span<const double> errors, double floor,
                              double ceiling) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!(errors[i] > floor && errors[i] < ceiling)) continue;
    x.push_back(std::log(steps[i]));
    y.push_back(std::log(errors[i]));
  }
  if (x.size() < 3) return std::nullopt;
  const LineFit fit = fitLine(x, y);
  return Order{fit.slope, fit.slopeError, static_cast<int>(x.size())};
}

std::vector<std::size_t> paretoFront(std::span<const double> costs, std::span<const double> errors) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < costs.size(); ++i)
    if (std::isfinite(costs[i]) && std::isfinite(errors[i])) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return costs[a] != costs[b] ? costs[a] < costs[b] : errors[a] < errors[b];
  });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order)
    if (errors[i] < least) {
      least = errors[i];
      front.push_back(i);
    }
  return front;
}

}  // namespace bedmix
