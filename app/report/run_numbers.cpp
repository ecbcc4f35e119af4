// SPDX-License-Identifier: MIT
#include "app/report/run_numbers.h"

#include "app/run_folder.h"
#include "engine/core/mixing.h"
#include "replay/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

struct Range {
  std::optional<double> mean, largest;
};

/// Of the defined values at times from `from` on.
Range rangeOf(const Table& table, std::string_view column, double from) {
  const Table::Column* time = table.find("time");
  const Table::Column* values = table.find(column);
  if (!time || !values) return {};
  double sum = 0.0, largest = -std::numeric_limits<double>::infinity();
  int count = 0;
  for (std::size_t i = 0; i < values->size(); ++i) {
    const std::optional<double> value = (*values)[i];
    if (!value || (*time)[i].value_or(0.0) < from) continue;
    sum += *value;
    largest = std::max(largest, *value);
    ++count;
  }
  if (count == 0) return {};
  return {sum / count, largest};
}

std::optional<double> mixingTime(const Table& mixing) {
  const Table::Column* time = mixing.find("time");
  const Table::Column* ashton = mixing.find("ashton");
  if (!time || !ashton) return std::nullopt;
  for (std::size_t i = 0; i < ashton->size(); ++i)
    if ((*ashton)[i].value_or(0.0) >= mixedIndex) return (*time)[i];
  return std::nullopt;
}

double endOf(const Table& table) {
  const Table::Column* time = table.find("time");
  return time && !time->empty() ? time->back().value_or(0.0) : 0.0;
}

class Numbers {
 public:
  void add(std::string name, std::optional<double> value, int decimals, std::string_view unit = "") {
    const std::string number = value ? fmt::format("{:.{}f}", *value, decimals) : "-";
    all_.push_back({std::move(name), value && !unit.empty() ? fmt::format("{} {}", number, unit) : number});
  }
  std::vector<RunNumber> take() { return std::move(all_); }

 private:
  std::vector<RunNumber> all_;
};

}  // namespace

Result<std::vector<RunNumber>> runNumbers(const fs::path& path, const Scene& scene) {
  const RunFolder folder{path};
  Numbers numbers;
  std::vector<Diagnostic> problems;
  const auto with = [&](const fs::path& file, const auto& use) {
    std::error_code none;
    if (!fs::exists(file, none)) return;
    const auto table = readCsv(file);
    if (table)
      use(*table);
    else
      problems.insert(problems.end(), table.problems.begin(), table.problems.end());
  };
  with(folder.mixing(), [&](const Table& mixing) {
    const double half = 0.5 * endOf(mixing);
    numbers.add(fmt::format("mixed: first A >= {:g}", mixedIndex), mixingTime(mixing), 2, "s");
    numbers.add("Ashton index A, mean of second half", rangeOf(mixing, "ashton", half).mean, 3);
    numbers.add("Ashton index A, largest of second half", rangeOf(mixing, "ashton", half).largest, 2);
    numbers.add("Lacey index M, mean of second half", rangeOf(mixing, "lacey", half).mean, 3);
    const Range counted = rangeOf(mixing, "counted_fraction", 0.0);
    numbers.add("particles in counted cells, mean", counted.mean, 3);
    numbers.add("particles in counted cells, largest", counted.largest, 3);
  });
  with(folder.flux(), [&](const Table& flux) {
    numbers.add("solids flux leftward, mean", rangeOf(flux, "flux", 0.0).mean, 1, "kg/(m\u00b2 s)");
  });
  with(folder.pressure(), [&](const Table& pressure) {
    const double half = 0.5 * endOf(pressure), weight = bedWeight(scene);
    const Range drop = rangeOf(pressure, "pressure_drop", half);
    numbers.add("pressure drop, mean of second half", drop.mean, 0, "Pa");
    if (weight > 0.0 && drop.mean)
      numbers.add(fmt::format("pressure drop over bed weight per area ({:.0f} Pa)", weight),
                  *drop.mean / weight, 3);
    const auto height = rangeOf(pressure, "bed_height", half).mean;
    numbers.add("bed height, mean of second half", height ? std::optional(1e3 * *height) : height, 0, "mm");
  });
  if (!problems.empty()) return problems;
  return numbers.take();
}

}  // namespace bedmix
