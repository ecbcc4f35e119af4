// SPDX-License-Identifier: MIT
#include "app/curves.h"

#include "app/recorded_runs.h"
#include "app/run_folder.h"
#include "engine/core/mixing.h"
#include "engine/core/scene_reader.h"
#include "render/band.h"
#include "replay/csv.h"
#include "replay/trajectory_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

std::vector<double> numbers(const Table::Column& column) {
  std::vector<double> values;
  values.reserve(column.size());
  for (const auto& v : column) values.push_back(v.value_or(std::nan("")));
  return values;
}

/// A curve a column of the kind, called by its label.
Result<std::vector<Curve>> columnsOf(const std::string& run, const PlotKind& kind) {
  const fs::path folder = runFolderOf(run), file = folder / kind.file;
  if (!hasSeries(folder, kind))
    return Diagnostic{{run},
                      fmt::format("this folder has no {}: either it is no run's, or the run's scene has no "
                                  "effect that gives one",
                                  kind.file),
                      Trouble::file};
  const auto table = readCsv(file);
  if (!table) return table.problems;
  const Table::Column* time = table->find("time");
  std::vector<Curve> curves;
  for (const PlotColumn& column : kind.columns) {
    const Table::Column* values = table->find(column.name);
    if (!time || !values)
      return Diagnostic{{file.string()},
                        fmt::format("lacks the column \"{}\"", time ? column.name : "time"),
                        Trouble::file};
    curves.push_back({std::string(column.label), numbers(*time), numbers(*values), {}, {}});
  }
  return curves;
}

/// What a curve is called, given its own name and that of its run or runs.
std::string curveName(const PlotKind& kind, const std::string& run, const std::string& column) {
  return kind.columns.size() > 1 ? run + ", " + column : run;
}

/// Runs that differ in their seed only.
struct Ensemble {
  std::string scene;     // its name
  std::string settings;  // all but the seed
  std::vector<std::string> runs;
};

Result<std::vector<Ensemble>> ensemblesOf(std::span<const std::string> runs) {
  std::vector<Ensemble> ensembles;
  for (const std::string& run : runs) {
    const auto reader = TrajectoryReader::open(run);
    if (!reader) return reader.problems;
    Scene scene = reader->scene();
    scene.seed = 0;
    const std::string settings = writeScene(scene);
    auto of = std::find_if(ensembles.begin(), ensembles.end(),
                           [&](const Ensemble& e) { return e.settings == settings; });
    if (of == ensembles.end()) of = ensembles.insert(of, {scene.name, settings, {}});
    of->runs.push_back(run);
  }
  return ensembles;
}

}  // namespace

bool hasSeries(const fs::path& folder, const PlotKind& kind) {
  std::error_code none;
  return fs::exists(folder / kind.file, none);
}

Result<std::vector<Curve>> curvesOf(std::span<const std::string> runs, const PlotKind& kind) {
  std::vector<Curve> curves;
  const std::vector<std::string> names = runNames(runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    auto ofRun = columnsOf(runs[i], kind);
    if (!ofRun) return ofRun.problems;
    if (runs.size() > 1)
      for (Curve& c : *ofRun) c.label = curveName(kind, names[i], c.label);
    std::move(ofRun->begin(), ofRun->end(), std::back_inserter(curves));
  }
  return curves;
}

Result<std::vector<Curve>> ensembleCurves(std::span<const std::string> runs, const PlotKind& kind) {
  const auto ensembles = ensemblesOf(runs);
  if (!ensembles) return ensembles.problems;
  std::vector<Curve> curves;
  for (const Ensemble& ensemble : *ensembles) {
    const bool known = std::count_if(ensembles->begin(), ensembles->end(),
                                     [&](const Ensemble& e) { return e.scene == ensemble.scene; }) == 1;
    const std::string name = known ? ensemble.scene : runNames(ensemble.runs).front();
    std::vector<std::vector<Curve>> columns(kind.columns.size());
    for (const std::string& run : ensemble.runs) {
      auto ofRun = columnsOf(run, kind);
      if (!ofRun) return ofRun.problems;
      for (std::size_t k = 0; k < columns.size(); ++k) columns[k].push_back(std::move((*ofRun)[k]));
    }
    for (const std::vector<Curve>& column : columns)
      curves.push_back(
          medianAndBand(column, fmt::format("{}, {} run{}", curveName(kind, name, column.front().label),
                                            column.size(), column.size() == 1 ? "" : "s")));
  }
  return curves;
}

std::vector<Level> levelsOf(std::span<const std::string> runs, const PlotKind& kind) {
  if (kind.file == "mixing.csv") return {{mixedIndex, fmt::format("A = {:g}", mixedIndex)}};
  if (kind.file != "pressure.csv") return {};
  std::optional<double> weight;
  for (const std::string& run : runs) {
    const auto reader = TrajectoryReader::open(run);
    if (!reader) return {};
    const double ofRun = bedWeight(reader->scene());
    if (weight && std::abs(*weight - ofRun) > 1e-6 * ofRun) return {};
    weight = ofRun;
  }
  return {{*weight, "bed weight / area"}};
}

}  // namespace bedmix
