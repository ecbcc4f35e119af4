// SPDX-License-Identifier: MIT
#include "replay/analysis/residence.h"

#include "replay/analysis/by_id.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

/// Classes of lengths grow by this factor; no whole number of intervals is between two.
const double growth = std::sqrt(2.0);

}  // namespace

Residence::Residence(const AnalysisInput& input)
    : scene_(input.scene), shortest_(input.interval / std::sqrt(growth)) {
  const double classes = 2.0 * std::log2(static_cast<double>(std::max<std::size_t>(input.frames, 2)));
  for (Stays& s : stays_) s.byLength.resize(static_cast<std::size_t>(classes) + 2);
}

void Residence::end(Zone zone, const std::optional<double>& since, double now) {
  Stays& stays = stays_[zone];
  stays.ends += 1.0;
  if (!since) return;
  const double index = std::floor(std::log((now - *since) / shortest_) / std::log(growth));
  const double last = static_cast<double>(stays.byLength.size() - 1);
  stays.byLength[static_cast<std::size_t>(std::clamp(index, 0.0, last))] += 1.0;
}

void Residence::accept(const Frame& frame) {
  const std::size_t n = frame.size();
  std::vector<double> height(n);
  for (std::size_t i = 0; i < n; ++i)
    height[i] = static_cast<double>(frame.position[i].y) -
                floorHeight(scene_, static_cast<double>(frame.position[i].x));
  double median = 0.0;
  if (n > 0) {
    std::vector<double> sorted = height;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(n / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    median = n % 2 ? *middle : 0.5 * (*middle + *std::max_element(sorted.begin(), middle));
  }
  const double d = scene_.particles.diameter, nearest = 3.0 * d;

  std::vector<Particle> particles(n);
  for (std::size_t i = 0; i < n; ++i) {
    particles[i].isUpper = height[i] >= median;
    particles[i].isNear = height[i] <= nearest;
  }
  const double now = frame.time;
  forParticlesInBoth(ids_, frame.id, [&](std::size_t i, std::size_t j) {
    Particle p = particles_[i];
    stays_[p.isUpper ? upper : lower].time += now - time_;
    stays_[p.isNear ? near : away].time += now - time_;
    stays_[cycle].time += now - time_;
    if (p.isUpper ? height[j] < median - d : height[j] > median + d) {
      end(p.isUpper ? upper : lower, p.half, now);
      if (p.isUpper) {
        end(cycle, p.fall, now);
        p.fall = now;
      }
      p.isUpper = !p.isUpper;
      p.half = now;
    }
    if (p.isNear ? height[j] > nearest + d : height[j] <= nearest) {
      end(p.isNear ? near : away, p.distributor, now);
      p.isNear = !p.isNear;
      p.distributor = now;
    }
    particles[j] = p;
  });
  particles_ = std::move(particles);
  ids_ = frame.id;
  time_ = now;
}

std::vector<NamedTable> Residence::tables() const {
  Table table{{"from", "to", "lower", "upper", "near", "away", "cycle"}, std::vector<Table::Column>(7)};
  double from = shortest_;
  for (std::size_t i = 0; i < stays_[lower].byLength.size(); ++i, from *= growth) {
    std::vector<std::optional<double>> row{from, from * growth};
    for (const Stays& s : stays_) row.push_back(s.byLength[i]);
    table.append(row);
  }
  return {{"residence", std::move(table)}};
}

std::optional<double> Residence::mean(Zone zone) const {
  const Stays& s = stays_[zone];
  return s.ends > 0.0 ? std::optional(s.time / s.ends) : std::nullopt;
}

std::vector<FoundNumber> Residence::findings() const {
  return {{"residence_lower", mean(lower), "s"},
          {"residence_upper", mean(upper), "s"},
          {"residence_near_distributor", mean(near), "s"},
          {"return_to_distributor", mean(away), "s"},
          {"cycle_time", mean(cycle), "s"}};
}

}  // namespace bedmix
