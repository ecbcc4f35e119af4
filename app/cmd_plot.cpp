// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/curves.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <memory>

namespace bedmix {

namespace {

struct PlotOptions {
  std::vector<std::string> runs;
  std::string output;
  std::string kind{plotKinds().front().name};
  bool band = false;
};

ExitCode plot(const PlotOptions& options, const Console& console) {
  auto kind = findPlotKind(options.kind);
  if (!kind) {
    for (Diagnostic& d : kind.problems) d.at.file = "--kind";
    return console.fail(kind.problems);
  }
  const auto curves = options.band ? ensembleCurves(options.runs, **kind) : curvesOf(options.runs, **kind);
  if (!curves) return console.fail(curves.problems);
  const auto written = writePlot(options.output, **kind, *curves, levelsOf(options.runs, **kind));
  if (!written) return console.fail(written.problems);
  console.say(fmt::format("{0}: {1} curves; beside it {0}.csv and {0}.gp", options.output, curves->size()));
  return ExitCode::done;
}

}  // namespace

void addPlotCommand(CLI::App& program, CommandContext context) {
  CLI::App* command = program.add_subcommand("plot", "Curves of one or several runs over time");
  auto options = std::make_shared<PlotOptions>();
  command->add_option("runs", options->runs, "Folders with a run's series, also those that replay wrote")
      ->required()
      ->type_name("RUN...");
  command
      ->add_option(
          "-o,--output", options->output,
          "A .png, .svg or .pdf file, 88 mm wide; FILE.csv and FILE.gp, what it draws and the gnuplot "
          "script, are put beside it")
      ->required()
      ->type_name("FILE");
  std::string names;
  for (const PlotKind& k : plotKinds()) names += fmt::format("{}{}", names.empty() ? "" : ", ", k.name);
  command->add_option("--kind", options->kind, "What to plot: " + names)
      ->type_name("KIND")
      ->capture_default_str();
  command->add_flag("--band", options->band,
                    "Runs of one scene that differ in the seed as their median and a band from 10 to 90 %");
  command->footer(
      "Examples:\n  bedmix plot out/even -o mixing.png\n"
      "  bedmix plot out/even out/inclined -o compare.pdf --kind compare\n"
      "  bedmix plot out/even-* out/inclined-* -o ensembles.svg --kind compare --band");
  command->callback([options, context] { context.outcome = plot(*options, context.console); });
}

}  // namespace bedmix
