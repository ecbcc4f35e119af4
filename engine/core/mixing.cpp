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

double mixtureEntropy(double c) {
  const auto part = [](double x) { return x > 0.0 ? -x * std::log(x) : 0.0; };
  return part(c) + part(1.0 - c);
}

CellStatistics cellStatistics(const CellCounts& counts, int minParticles) {
  CellStatistics s;
  const auto forUsed = [&](const auto& use) {
    for (std::size_t c = 0; c < counts.all.size(); ++c)
      if (counts.all[c] >= minParticles)
        use(counts.all[c], static_cast<double>(counts.tracer[c]) / counts.all[c], counts.tracer[c]);
  };
  double sum = 0.0;
  forUsed([&](std::int32_t n, double fraction, std::int32_t tracer) {
    ++s.cells;
    s.particles += n;
    s.tracer += tracer;
    sum += fraction;
  });
  if (s.cells == 0) return s;
  s.mean = sum / s.cells;
  s.perCell = static_cast<double>(s.particles) / s.cells;
  s.segregated = s.mean * (1.0 - s.mean);
  s.random = s.segregated / s.perCell;

  const double whole = static_cast<double>(s.tracer) / static_cast<double>(s.particles);
  double squares = 0.0, weighted = 0.0, entropy = 0.0;
  forUsed([&](std::int32_t n, double fraction, std::int32_t) {
    squares += (fraction - s.mean) * (fraction - s.mean);
    weighted += n * (fraction - whole) * (fraction - whole);
    entropy += n * mixtureEntropy(fraction);
  });
  if (s.cells > 1) s.variance = squares / (s.cells - 1);
  s.weightedVariance = weighted / static_cast<double>(s.particles);
  s.entropy = entropy / static_cast<double>(s.particles);
  return s;
}

std::optional<double> laceyIndex(const CellStatistics& s) {
  if (!s.defined()) return std::nullopt;
  return (s.segregated - *s.variance) / (s.segregated - s.random);
}

std::optional<double> ashtonIndex(const CellStatistics& s) {
  if (!s.defined() || !(*s.variance > 0.0)) return std::nullopt;
  return (std::log(s.segregated) - std::log(*s.variance)) / (std::log(s.segregated) - std::log(s.random));
}

MixingSample mixingSample(const CellStatistics& cells, double time, std::size_t particles) {
  MixingSample sample;
  sample.time = time;
  sample.cells = cells.cells;
  if (particles > 0)
    sample.countedFraction = static_cast<double>(cells.particles) / static_cast<double>(particles);
  if (cells.cells == 0) return sample;
  sample.tracerMean = cells.mean;
  sample.particlesPerCell = cells.perCell;
  if (cells.variance) sample.stddev = std::sqrt(*cells.variance);
  sample.lacey = laceyIndex(cells);
  sample.ashton = ashtonIndex(cells);
  return sample;
}

MixingSample mixingSample(const Frame& frame, const SamplingGrid& grid) {
  return mixingSample(cellStatistics(countCells(frame, grid), grid.minParticles), frame.time, frame.size());
}

}  // namespace bedmix
