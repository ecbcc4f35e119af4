// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/picture_options.h"
#include "app/png_text.h"
#include "app/recorded_runs.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <memory>

namespace bedmix {

namespace {

struct SheetOptions {
  std::vector<std::string> runs;
  std::string output;
  std::vector<double> times;  // s
  StyleOptions style;
};

/// Particles and walls where the options do not name layers.
Result<Style> sheetStyleFor(const SheetOptions& options, const Scene& scene) {
  auto style = styleFor(options.style, scene);
  if (!style) return style;
  if (options.style.layers.empty()) style->layers = sheetStyle.layers;
  for (const Layer layer : {Layer::hud, Layer::curve, Layer::trails})
    if (style->layers.has(layer))
      return Diagnostic{
          {"--layers"},
          fmt::format("{} has no place in a sheet, which has its times, scale and legend anyway",
                      modelName(layer))};
  return style;
}

ExitCode sheet(const SheetOptions& options, const Console& console) {
  if (!options.output.ends_with(".png"))
    return console.fail("--output", fmt::format("a sheet is a .png picture, not \"{}\"", options.output));
  auto runs = openRuns(options.runs);
  if (!runs) return console.fail(runs.problems);
  const auto style = sheetStyleFor(options, runs->front().scene());
  if (!style) return console.fail(style.problems);
  const auto image = sheetOf(*runs, options.times, *style);
  if (!image) return console.fail(image.problems);
  const auto written = writePng(options.output, *image, sheetPng(*runs));
  if (!written) return console.fail(written.problems);
  console.say(fmt::format("{}: {} x {} pixels, {:.0f} mm wide in print", options.output, image->size.width,
                          image->size.height, image->size.width / sheetDpi * 25.4));
  return ExitCode::done;
}

}  // namespace

void addSheetCommand(CLI::App& program, CommandContext context) {
  CLI::App* command =
      program.add_subcommand("sheet", "Contact sheet of runs at several times, a row a run, for print");
  auto options = std::make_shared<SheetOptions>();
  command->add_option("runs", options->runs, "Folders of runs, or their trajectory.h5")
      ->required()
      ->type_name("RUN...");
  command->add_option("-o,--output", options->output, "The picture")->required()->type_name("FILE.png");
  command->add_option("--times", options->times, "Simulated seconds; 0, 0.5, 1, 2, 3, ... by default")
      ->type_name("T,T,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  addStyleOptions(*command, options->style);
  command->footer(
      "Examples:\n  bedmix sheet out/even -o sheet.png --times 0,0.5,1,2,3,4,5,6,7\n"
      "  bedmix sheet out/even out/inclined -o both.png --times 0.2,0.5,1,2,4\n"
      "  bedmix sheet out/even -o strips.png --color strips:6");
  command->callback([options, context] { context.outcome = sheet(*options, context.console); });
}

}  // namespace bedmix
