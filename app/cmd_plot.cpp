// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "render/plot.h"
#include "replay/csv.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

struct PlotOptions {
  std::vector<std::string> runs;
  std::string output;
  std::string kind{plotKinds().front().name};
};

/// The name of a run for a legend: that of its folder.
std::string runName(const std::string& run) { return fs::weakly_canonical(run).filename().string(); }

std::vector<double> numbers(const Table::Column& column) {
  std::vector<double> values;
  values.reserve(column.size());
  for (const auto& v : column) values.push_back(v.value_or(std::nan("")));
  return values;
}

Result<std::vector<Curve>> curvesOf(const std::string& run, const PlotKind& kind, bool several) {
  const fs::path file = fs::path(run) / kind.file;
  std::error_code none;
  if (!fs::exists(file, none))
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
    const std::string label(column.label);
    const bool oneColumn = kind.columns.size() == 1;
    curves.push_back({several ? (oneColumn ? runName(run) : runName(run) + ", " + label) : label,
                      numbers(*time), numbers(*values)});
  }
  return curves;
}

ExitCode plot(const PlotOptions& options, const Console& console) {
  auto kind = findPlotKind(options.kind);
  if (!kind) {
    for (Diagnostic& d : kind.problems) d.at.file = "--kind";
    return console.fail(kind.problems);
  }
  std::vector<Curve> curves;
  for (const std::string& run : options.runs) {
    auto ofRun = curvesOf(run, **kind, options.runs.size() > 1);
    if (!ofRun) return console.fail(ofRun.problems);
    std::move(ofRun->begin(), ofRun->end(), std::back_inserter(curves));
  }
  const auto written = writePlot(options.output, **kind, curves);
  if (!written) return console.fail(written.problems);
  console.say(fmt::format("{}: {} curves", options.output, curves.size()));
  return ExitCode::done;
}

}  // namespace

void addPlotCommand(CLI::App& program, CommandContext context) {
  CLI::App* command = program.add_subcommand("plot", "Curves of one or several runs over time");
  auto options = std::make_shared<PlotOptions>();
  command->add_option("runs", options->runs, "Folders with a run's series, also those that replay wrote")
      ->required()
      ->type_name("RUN...");
  command->add_option("-o,--output", options->output, "A .png, .svg or .pdf file")
      ->required()
      ->type_name("FILE");
  std::string names;
  for (const PlotKind& k : plotKinds()) names += fmt::format("{}{}", names.empty() ? "" : ", ", k.name);
  command->add_option("--kind", options->kind, "What to plot: " + names)
      ->type_name("KIND")
      ->capture_default_str();
  command->footer(
      "Examples:\n  bedmix plot out/even -o mixing.png\n"
      "  bedmix plot out/even out/inclined -o compare.pdf --kind compare");
  command->callback([options, context] { context.outcome = plot(*options, context.console); });
}

}  // namespace bedmix
