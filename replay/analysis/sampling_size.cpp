// SPDX-License-Identifier: MIT
#include "replay/analysis/sampling_size.h"

#include "engine/core/mixing_indices.h"
#include "engine/core/neighbour_index.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bedmix {

std::vector<SamplingGrid> samplingSeries(const Scene& scene) {
  const SamplingGrid own = samplingGrid(scene);
  const double disc = 0.25 * std::numbers::pi * scene.particles.diameter * scene.particles.diameter;
  std::vector<SamplingGrid> series;
  for (double scale = 0.25;; scale *= std::numbers::sqrt2) {
    SamplingGrid grid = own;
    grid.columns = std::max(2, static_cast<int>(std::lround(scale * own.columns)));
    grid.rows = std::max(2, static_cast<int>(std::lround(scale * own.rows)));
    const double width = own.width / grid.columns, height = own.height / grid.rows;
    if (std::min(width, height) < 1.5 * scene.particles.diameter) return series;
    grid.minParticles = std::max(1, static_cast<int>(0.5 * 0.8 * width * height / disc));
    if (series.empty() || grid.cells() > series.back().cells()) series.push_back(grid);
  }
}

void SamplingSize::Mean::add(std::optional<double> value) {
  if (!value) return;
  sum += *value;
  ++defined;
}

std::optional<double> SamplingSize::Mean::value() const {
  if (defined == 0) return std::nullopt;
  return sum / static_cast<double>(defined);
}

SamplingSize::SamplingSize(const AnalysisInput& input) : frames_(input.frames), period_(input.scene) {
  for (const SamplingGrid& grid : samplingSeries(input.scene)) series_.push_back({grid, {}});
}

void SamplingSize::accept(const Frame& frame) {
  if (seen_++ < frames_ / 2) return;
  for (auto& [grid, means] : series_) {
    const CellStatistics cells = cellStatistics(countCells(frame, grid), grid.minParticles);
    const auto used = static_cast<double>(cells.cells);
    means[0].add(cells.cells > 0 ? std::optional(cells.perCell) : std::nullopt);
    means[1].add(used);
    means[2].add(laceyIndex(cells));
    means[3].add(ashtonIndex(cells));
    means[4].add(weightedLaceyIndex(cells));
  }
  neighbours_.add(neighbourIndex(frame, planeNeighbours, period_));
}

std::vector<NamedTable> SamplingSize::tables() const {
  Table table{{"columns", "rows", "min_particles", "particles_per_cell", "cells", "lacey", "ashton",
               "lacey_weighted", "nearest_neighbour"},
              std::vector<Table::Column>(9)};
  for (const auto& [grid, means] : series_)
    table.append({static_cast<double>(grid.columns), static_cast<double>(grid.rows),
                  static_cast<double>(grid.minParticles), means[0].value(), means[1].value(),
                  means[2].value(), means[3].value(), means[4].value(), neighbours_.value()});
  return {{"sampling", table}};
}

std::vector<FoundNumber> SamplingSize::findings() const {
  const auto spread = [this](std::size_t index) -> std::optional<double> {
    std::optional<double> low, high;
    for (const Series& s : series_) {
      const auto mean = s.means[index].value();
      if (!mean) continue;
      low = std::min(low.value_or(*mean), *mean);
      high = std::max(high.value_or(*mean), *mean);
    }
    if (!low) return std::nullopt;
    return *high - *low;
  };
  return {{"lacey_spread_over_sampling", spread(2), ""},
          {"ashton_spread_over_sampling", spread(3), ""},
          {"lacey_weighted_spread_over_sampling", spread(4), ""}};
}

}  // namespace bedmix
