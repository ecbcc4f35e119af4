// SPDX-License-Identifier: MIT
#include "replay/analysis/spectrum.h"

#include "engine/core/bed_statistics.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/FFT>

namespace bedmix {

namespace {

double mean(const std::vector<double>& series) {
  return std::accumulate(series.begin(), series.end(), 0.0) / static_cast<double>(series.size());
}

/// Samples in a segment.
std::size_t segmentOf(std::size_t samples) {
  std::size_t segment = 1;
  while (6 * segment <= samples) segment *= 2;
  return segment;
}

/// One-sided density at the frequencies 1, 2, ... `segment`/2 over the segment's duration.
std::vector<double> welch(const std::vector<double>& series, std::size_t segment, double interval) {
  const double average = mean(series);
  std::vector<double> window(segment), part(segment), density(segment / 2);
  double norm = 0.0;
  for (std::size_t i = 0; i < segment; ++i) {
    window[i] =
        0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(segment));
    norm += window[i] * window[i];
  }
  Eigen::FFT<double> transform;
  std::vector<std::complex<double>> modes;
  double segments = 0.0;
  for (std::size_t from = 0; from + segment <= series.size(); from += segment / 2, segments += 1.0) {
    for (std::size_t i = 0; i < segment; ++i) part[i] = window[i] * (series[from + i] - average);
    transform.fwd(modes, part);
    for (std::size_t k = 1; k <= density.size(); ++k)
      density[k - 1] += (2 * k == segment ? 1.0 : 2.0) * std::norm(modes[k]);
  }
  for (double& d : density) d *= interval / (norm * segments);
  return density;
}

std::optional<double> dominant(const Table& table, std::size_t column) {
  std::optional<std::size_t> at;
  for (std::size_t r = 0; r < table.rows(); ++r)
    if (const auto& power = table.columns[column][r]; power && (!at || *power > *table.columns[column][*at]))
      at = r;
  return at ? table.columns[0][*at] : std::nullopt;
}

std::optional<double> deviation(const std::vector<double>& series) {
  if (series.size() < 2) return std::nullopt;
  const double average = mean(series);
  double squares = 0.0;
  for (double value : series) squares += (value - average) * (value - average);
  return std::sqrt(squares / static_cast<double>(series.size() - 1));
}

}  // namespace

Spectrum::Spectrum(const AnalysisInput& input) : scene_(input.scene), interval_(input.interval) {
  if (scene_.gas) grid_ = makeGasGrid(scene_);
}

void Spectrum::accept(const Frame& frame) {
  height_.push_back(bedHeight(frame, scene_));
  if (grid_ && frame.hasGas()) pressure_.push_back(pressureDrop(frame, *grid_));
}

Table Spectrum::table() const {
  Table table{{"frequency", "pressure_drop", "bed_height"}, std::vector<Table::Column>(3)};
  const std::size_t segment = segmentOf(height_.size());
  if (segment < 4 || !(interval_ > 0.0)) return table;
  const std::vector<double> height = welch(height_, segment, interval_);
  std::vector<double> pressure;
  if (pressure_.size() == height_.size()) pressure = welch(pressure_, segment, interval_);
  for (std::size_t k = 0; k < height.size(); ++k)
    table.append({static_cast<double>(k + 1) / (static_cast<double>(segment) * interval_),
                  pressure.empty() ? std::nullopt : std::optional(pressure[k]), height[k]});
  return table;
}

std::vector<FoundNumber> Spectrum::findings() const {
  const Table all = table();
  std::vector<FoundNumber> found;
  if (grid_)
    found = {{"pressure_frequency", dominant(all, 1), "Hz"},
             {"pressure_deviation", deviation(pressure_), "Pa"}};
  found.push_back({"height_frequency", dominant(all, 2), "Hz"});
  found.push_back({"height_deviation", deviation(height_), "m"});
  return found;
}

}  // namespace bedmix
