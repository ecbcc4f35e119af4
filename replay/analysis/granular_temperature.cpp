// SPDX-License-Identifier: MIT
#include "replay/analysis/granular_temperature.h"

namespace bedmix {

GranularTemperature::GranularTemperature(const AnalysisInput& input)
    : grid_(samplingGrid(input.scene)),
      table_{{"time", "temperature", "temperature_x", "temperature_y"}, std::vector<Table::Column>(4)} {}

void GranularTemperature::accept(const Frame& frame) {
  struct Sums {
    std::int64_t n = 0;
    Vec2 v{}, squares{};
  };
  std::vector<Sums> cells(static_cast<std::size_t>(grid_.columns) * static_cast<std::size_t>(grid_.rows));
  forParticlesInCells(frame, grid_, [&](std::size_t cell, std::size_t i) {
    const double vx = frame.velocity[i].x, vy = frame.velocity[i].y;
    Sums& s = cells[cell];
    ++s.n;
    s.v += Vec2{vx, vy};
    s.squares += Vec2{vx * vx, vy * vy};
  });
  std::int64_t n = 0;
  double x = 0.0, y = 0.0;
  for (const Sums& s : cells) {
    if (s.n < grid_.minParticles) continue;
    n += s.n;
    x += s.squares.x - s.v.x * s.v.x / static_cast<double>(s.n);
    y += s.squares.y - s.v.y * s.v.y / static_cast<double>(s.n);
  }
  std::optional<double> tx, ty, t;
  if (n > 0) {
    tx = x / static_cast<double>(n);
    ty = y / static_cast<double>(n);
    t = (*tx + *ty) / 2.0;
  }
  table_.append({frame.time, t, tx, ty});
}

std::vector<FoundNumber> GranularTemperature::findings() const {
  return {{"granular_temperature", meanOf(table_.columns[1]), "m2/s2"}};
}

}  // namespace bedmix
