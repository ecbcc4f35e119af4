// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/gl_option.h"
#include "app/picture_options.h"
#include "app/recorded_runs.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <memory>

namespace bedmix {

namespace {

struct SheetOptions {
  std::vector<std::string> runs;
  RecordingOptions recording;
  std::string output;
  std::vector<double> times;  // s
  PictureOptions picture;
};

/// The scene's own style with what the options change in it, but the layers of a sheet.
Result<Style> styleFor(const PictureOptions& options, const Scene& scene) {
  const auto paint = paintOptions(options, scene);
  if (!paint) return paint.problems;
  Style style = paint->style;
  if (options.layers.empty()) {
    const bool trails = !options.trails.empty();
    style.layers = sheetLayers;
    if (trails) style.layers.add(Layer::trails);
  }
  if (style.layers.has(Layer::hud) || style.layers.has(Layer::curve))
    return Diagnostic{{"--layers"},
                      "hud and curve have no place in a sheet, which has its times, scale and legend anyway"};
  return style;
}

ExitCode sheet(const SheetOptions& options, const Console& console) {
  if (!options.output.ends_with(".png"))
    return console.fail("--output", fmt::format("a sheet is a .png picture, not \"{}\"", options.output));
  auto runs = openRuns(options.runs, options.recording);
  if (!runs) return console.fail(runs.problems);
  const auto style = styleFor(options.picture, runs->front().scene());
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
  addStyleOptions(*command, options->picture);
  addGlOption(*command);
  addRecordingOptions(*command, options->recording);
  command->footer(
      "Examples:\n  bedmix sheet out/even -o sheet.png --times 0,0.5,1,2,3,4,5,6,7\n"
      "  bedmix sheet out/even out/inclined -o both.png --times 0.2,0.5,1,2,4");
  command->callback([options, context] { context.outcome = sheet(*options, context.console); });
}

}  // namespace bedmix
