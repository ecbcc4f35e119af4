// SPDX-License-Identifier: MIT
#include "replay/analysis/crossings.h"

#include "engine/core/bed_statistics.h"
#include "replay/analysis/by_id.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bedmix {

Crossings::Crossings(const AnalysisInput& input)
    : scene_(input.scene),
      period_(input.scene),
      spacing_(input.scene.particles.diameter),
      // As high as particles get above an open top; what rises higher counts as just below that.
      lines_(static_cast<std::size_t>(std::clamp(2.0 * input.scene.bed.height / spacing_, 1.0, 1e5))),
      stretches_(lines_.size()) {}

std::size_t Crossings::lineBelow(double height) const {
  return static_cast<std::size_t>(
      std::clamp(std::floor(height / spacing_), 0.0, static_cast<double>(lines_.size() - 1)));
}

void Crossings::accept(const Frame& frame) {
  const double middle = 0.5 * scene_.bed.width;
  const auto heightOf = [&](Vec2f at) {
    return static_cast<double>(at.y) - floorHeight(scene_, static_cast<double>(at.x));
  };
  if (started_) duration_ += frame.time - previous_.time;
  started_ = true;
  forParticlesInBoth(previous_.id, frame.id, [&](std::size_t i, std::size_t j) {
    const Vec2f from = previous_.position[i], to = period_.next(from, frame.position[j]);
    const double low = heightOf(from), high = heightOf(to);
    const std::size_t below = lineBelow(low), above = lineBelow(high);
    for (std::size_t line = below; line < above; ++line) lines_[line + 1].with += 1.0;
    for (std::size_t line = above; line < below; ++line) lines_[line + 1].against += 1.0;

    const double left = static_cast<double>(from.x) - middle, right = static_cast<double>(to.x) - middle;
    if ((left >= 0.0) == (right >= 0.0)) return;
    Count& stretch = stretches_[lineBelow(low + (high - low) * left / (left - right))];
    (left >= 0.0 ? stretch.with : stretch.against) += 1.0;
  });
  frames_ += 1.0;
  heights_ += bedHeight(frame, scene_);
  previous_.time = frame.time;
  previous_.position = frame.position;
  previous_.id = frame.id;
}

std::vector<NamedTable> Crossings::tables() const {
  Table horizontal{{"height", "up", "down", "net"}, std::vector<Table::Column>(4)};
  Table vertical{{"height", "left", "right", "net"}, std::vector<Table::Column>(4)};
  if (!(duration_ > 0.0)) return {{"flux_horizontal", horizontal}, {"flux_vertical", vertical}};
  const double each = particleMass(scene_) / (duration_ * scene_.bed.thickness);
  const auto fill = [](Table& table, const std::vector<Count>& counts, double scale, auto heightOf) {
    std::size_t end = counts.size();
    while (end > 0 && counts[end - 1].with == 0.0 && counts[end - 1].against == 0.0) --end;
    for (std::size_t i = 0; i < end; ++i)
      table.append({heightOf(static_cast<double>(i)), scale * counts[i].with, scale * counts[i].against,
                    scale * (counts[i].with - counts[i].against)});
  };
  fill(horizontal, lines_, each / scene_.bed.width, [&](double i) { return spacing_ * i; });
  fill(vertical, stretches_, each / spacing_, [&](double i) { return spacing_ * (i + 0.5); });
  return {{"flux_horizontal", std::move(horizontal)}, {"flux_vertical", std::move(vertical)}};
}

std::vector<FoundNumber> Crossings::findings() const {
  const std::vector<NamedTable> made = tables();
  const Table &horizontal = made[0].table, &vertical = made[1].table;
  const double height = frames_ > 0.0 ? heights_ / frames_ : 0.0;
  std::vector<FoundNumber> found;
  for (int percent : {25, 50, 75}) {
    const std::size_t line = lineBelow(0.01 * percent * height + 0.5 * spacing_);  // the nearest
    const auto value = [&](std::size_t column) {
      return line < horizontal.rows() ? horizontal.columns[column][line] : std::nullopt;
    };
    found.push_back({fmt::format("flux_up_{}", percent), value(1), "kg/(m2 s)"});
    found.push_back({fmt::format("flux_down_{}", percent), value(2), "kg/(m2 s)"});
  }
  const std::size_t stretches = std::max<std::size_t>(1, lineBelow(height + 0.5 * spacing_));
  for (std::size_t way : {1u, 2u}) {
    std::optional<double> mean;
    if (duration_ > 0.0) {
      mean = 0.0;
      for (std::size_t i = 0; i < std::min(stretches, vertical.rows()); ++i)
        *mean += *vertical.columns[way][i] / static_cast<double>(stretches);
    }
    found.push_back({way == 1 ? "flux_left" : "flux_right", mean, "kg/(m2 s)"});
  }
  return found;
}

}  // namespace bedmix
