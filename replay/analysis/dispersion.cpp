// SPDX-License-Identifier: MIT
#include "replay/analysis/dispersion.h"

#include "engine/core/bed_statistics.h"
#include "replay/analysis/by_id.h"

#include <algorithm>

namespace bedmix {

namespace {

constexpr std::size_t originCount = 16;

/// Half the least-squares slope of a column of `table` over its lags, as long as the root of its values lies
/// between `low` and `high`; and the longest lag of those.
struct Fit {
  std::optional<double> coefficient, until;
};
Fit fit(const Table& table, std::size_t column, double low, double high) {
  double n = 0.0, t = 0.0, y = 0.0, tt = 0.0, ty = 0.0;
  Fit found;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    if (!table.columns[column][r]) continue;
    const double lag = *table.columns[0][r], value = *table.columns[column][r];
    if (value > high * high) break;
    if (value < low * low) continue;
    n += 1.0;
    t += lag;
    y += value;
    tt += lag * lag;
    ty += lag * value;
    found.until = lag;
  }
  if (n < 2.0) return {};
  found.coefficient = 0.5 * (n * ty - t * y) / (n * tt - t * t);
  return found;
}

}  // namespace

Dispersion::Dispersion(const AnalysisInput& input)
    : scene_(input.scene),
      paths_(input.scene),
      interval_(input.interval),
      every_((input.frames + originCount - 1) / originCount),
      sums_(input.frames / 2) {}

void Dispersion::accept(const Frame& frame) {
  const std::vector<Vec2f>& position = paths_.follow(frame);
  for (const Origin& origin : origins_) {
    const std::size_t lag = seen_ - origin.index;
    if (lag > sums_.size()) continue;
    double n = 0.0;
    Vec2 sum{}, squares{};
    forParticlesInBoth(origin.id, frame.id, [&](std::size_t i, std::size_t j) {
      const double x = static_cast<double>(position[j].x) - static_cast<double>(origin.position[i].x);
      const double y = static_cast<double>(position[j].y) - static_cast<double>(origin.position[i].y);
      n += 1.0;
      sum += Vec2{x, y};
      squares += Vec2{x * x, y * y};
    });
    if (n < 2.0) continue;
    const Vec2 spread = squares - Vec2{sum.x * sum.x, sum.y * sum.y} * (1.0 / n);
    sums_[lag - 1].msd += spread * (1.0 / (n - 1.0));
    ++sums_[lag - 1].origins;
  }
  if (seen_ % every_ == 0) origins_.push_back({seen_, frame.id, position});
  heights_ += bedHeight(frame, scene_);
  ++seen_;
}

Table Dispersion::table() const {
  Table table{{"lag", "msd_x", "msd_y"}, std::vector<Table::Column>(3)};
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const Sum& s = sums_[i];
    if (s.origins == 0) continue;
    table.append({interval_ * static_cast<double>(i + 1), s.msd.x / s.origins, s.msd.y / s.origins});
  }
  return table;
}

std::vector<FoundNumber> Dispersion::findings() const {
  const Table all = table();
  const double shortest = scene_.particles.diameter;
  const double height = heights_ / static_cast<double>(std::max<std::size_t>(seen_, 1));
  const Fit x = fit(all, 1, shortest, 0.25 * scene_.bed.width), y = fit(all, 2, shortest, 0.25 * height);
  return {{"dispersion_x", x.coefficient, "m2/s"},
          {"dispersion_x_until", x.until, "s"},
          {"dispersion_y", y.coefficient, "m2/s"},
          {"dispersion_y_until", y.until, "s"}};
}

}  // namespace bedmix
