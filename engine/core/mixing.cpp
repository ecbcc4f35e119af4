// SPDX-License-Identifier: MIT
#include "engine/core/mixing.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

SamplingGrid samplingGrid(const Scene& scene) {
  const SamplingSettings& s = scene.sampling;
  return {static_cast<int>(s.columns), static_cast<int>(s.rows), static_cast<int>(s.minParticles),
          scene.bed.width, scene.bed.height};
}

CellCounts countCells(const Frame& frame, const SamplingGrid& grid) {
  CellCounts counts{std::vector<std::int32_t>(grid.cells()), std::vector<std::int32_t>(grid.cells())};
  forParticlesInCells(frame, grid, [&](std::size_t cell, std::size_t i) {
    ++counts.all[cell];
    counts.tracer[cell] += frame.species[i] == 1;
  });
  return counts;
}

std::vector<Vec2> meanVelocities(const Frame& frame, const SamplingGrid& grid, std::int32_t fewest) {
  std::vector<Vec2> mean(grid.cells());
  std::vector<std::int32_t> counts(grid.cells());
  forParticlesInCells(frame, grid, [&](std::size_t cell, std::size_t i) {
    mean[cell] += Vec2{static_cast<double>(frame.velocity[i].x), static_cast<double>(frame.velocity[i].y)};
    ++counts[cell];
  });
  for (std::size_t cell = 0; cell < grid.cells(); ++cell)
    mean[cell] = counts[cell] < std::max(fewest, 1) ? Vec2{} : mean[cell] * (1.0 / counts[cell]);
  return mean;
}

MixingSample mixingSample(const CellCounts& counts, int minParticles, double time, std::size_t particles) {
  MixingSample sample;
  sample.time = time;
  std::int64_t counted = 0;
  double sum = 0.0;
  for (std::size_t c = 0; c < counts.all.size(); ++c) {
    if (counts.all[c] < minParticles) continue;
    ++sample.cells;
    counted += counts.all[c];
    sum += static_cast<double>(counts.tracer[c]) / counts.all[c];
  }
  if (particles > 0) sample.countedFraction = static_cast<double>(counted) / static_cast<double>(particles);
  if (sample.cells == 0) return sample;

  const double mean = sum / sample.cells;
  const double perCell = static_cast<double>(counted) / sample.cells;
  sample.tracerMean = mean;
  sample.particlesPerCell = perCell;
  if (sample.cells < 2) return sample;

  double squares = 0.0;
  for (std::size_t c = 0; c < counts.all.size(); ++c) {
    if (counts.all[c] < minParticles) continue;
    const double deviation = static_cast<double>(counts.tracer[c]) / counts.all[c] - mean;
    squares += deviation * deviation;
  }
  const double variance = squares / (sample.cells - 1);  // S^2, Eq. (13)
  const double segregated = mean * (1.0 - mean);         // sigma_0^2
  const double random = segregated / perCell;            // sigma_r^2
  sample.stddev = std::sqrt(variance);
  if (!(segregated > random)) return sample;  // one species only, or one particle a cell

  sample.lacey = (segregated - variance) / (segregated - random);
  if (variance > 0.0)
    sample.ashton = (std::log(segregated) - std::log(variance)) / (std::log(segregated) - std::log(random));
  return sample;
}

MixingSample mixingSample(const Frame& frame, const SamplingGrid& grid) {
  return mixingSample(countCells(frame, grid), grid.minParticles, frame.time, frame.size());
}

}  // namespace bedmix
