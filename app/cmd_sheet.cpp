// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/gl_option.h"
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
  std::string layers;
};

Result<Style> styleFor(const SheetOptions& options) {
  if (options.layers.empty()) return sheetStyle;
  auto layers = parseLayers(options.layers);
  if (layers && layers->has(Layer::hud))
    layers = Diagnostic{{}, "hud has no place in a sheet, which has its times, scale and legend anyway"};
  if (layers) return Style(*layers);
  for (Diagnostic& d : layers.problems) d.at.file = "--layers";
  return layers.problems;
}

ExitCode sheet(const SheetOptions& options, const Console& console) {
  if (!options.output.ends_with(".png"))
    return console.fail("--output", fmt::format("a sheet is a .png picture, not \"{}\"", options.output));
  const auto style = styleFor(options);
  if (!style) return console.fail(style.problems);
  auto runs = openRuns(options.runs);
  if (!runs) return console.fail(runs.problems);
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
  command
      ->add_option("--layers", options->layers,
                   "What to show, as of bedmix render; particles,walls by default")
      ->type_name("LIST");
  addGlOption(*command);
  command->footer(
      "Examples:\n  bedmix sheet out/even -o sheet.png --times 0,0.5,1,2,3,4,5,6,7\n"
      "  bedmix sheet out/even out/inclined -o both.png --times 0.2,0.5,1,2,4");
  command->callback([options, context] { context.outcome = sheet(*options, context.console); });
}

}  // namespace bedmix
