// SPDX-License-Identifier: MIT
#include "replay/analysis/indices.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace bedmix {

namespace {

std::vector<std::string> columnNames() {
  std::vector<std::string> names{"time"};
  for (const MixingIndex& index : mixingIndices()) names.emplace_back(index.name);
  names.emplace_back("principal_angle_deg");
  return names;
}

}  // namespace

std::optional<double> timeToReach(const Table::Column& times, const Table::Column& values, double level,
                                  double window) {
  const double half = 0.5 * window, rounding = 1e-9 * window;
  for (std::size_t i = 0, first = 0; i < times.size(); ++i) {
    if (*times[i] - half < *times.front() - rounding) continue;
    if (*times[i] + half > *times.back() + rounding) break;
    while (*times[first] < *times[i] - half - rounding) ++first;
    Table::Column within;
    for (std::size_t j = first; j < times.size() && *times[j] <= *times[i] + half + rounding; ++j)
      within.push_back(values[j]);
    if (const auto mean = meanOf(within); mean && *mean >= level) return times[i];
  }
  return std::nullopt;
}

std::optional<double> secondHalfMean(const Table::Column& column) {
  const auto half = static_cast<std::ptrdiff_t>(column.size() / 2);
  return meanOf(Table::Column(column.begin() + half, column.end()));
}

Indices::Indices(const AnalysisInput& input)
    : grid_(samplingGrid(input.scene)), period_(input.scene), table_{columnNames(), {}} {
  table_.columns.resize(table_.names.size());
}

void Indices::accept(const Frame& frame) {
  if (!start_) start_.emplace(frame);
  const CellStatistics cells = cellStatistics(countCells(frame, grid_), grid_.minParticles);
  const MixingState state{frame, cells, *start_, period_};
  std::vector<std::optional<double>> row{frame.time};
  for (const MixingIndex& index : mixingIndices()) row.push_back(index.of(state));
  const auto component = start_->with(frame);
  row.push_back(component ? std::optional(component->angle * 180.0 / std::numbers::pi) : std::nullopt);
  table_.append(row);
}

std::vector<FoundNumber> Indices::findings() const {
  std::vector<FoundNumber> found;
  for (const MixingIndex& index : mixingIndices())
    found.push_back(
        {fmt::format("{}_second_half", index.name), secondHalfMean(*table_.find(index.name)), ""});
  for (const std::string_view name : {"lacey", "ashton"})
    found.push_back({fmt::format("time_to_{}_{}_over_{}_s", name, mixedIndex, mixedWindow),
                     timeToReach(table_.columns.front(), *table_.find(name), mixedIndex, mixedWindow), "s"});
  return found;
}

}  // namespace bedmix
