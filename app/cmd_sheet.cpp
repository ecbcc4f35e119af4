// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/gl_option.h"
#include "app/png_text.h"
#include "render/sheet.h"
#include "replay/trajectory_reader.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <memory>

namespace bedmix {

namespace {

struct SheetOptions {
  std::string run;
  std::string output;
  std::vector<double> times;  // s
};

ExitCode sheet(const SheetOptions& options, const Console& console) {
  if (!options.output.ends_with(".png"))
    return console.fail("--output", fmt::format("a sheet is a .png picture, not \"{}\"", options.output));
  auto reader = TrajectoryReader::open(options.run);
  if (!reader) return console.fail(reader.problems);
  FramesAt wanted(options.times.empty() ? defaultSheetTimes(reader->times().back()) : options.times);
  FrameSink* const sinks[]{&wanted};
  drain(*reader, sinks);
  if (reader->failure()) return console.fail(*reader->failure());
  auto frames = wanted.frames();
  if (!frames) {
    for (Diagnostic& d : frames.problems) d.at.file = "--times";
    return console.fail(frames.problems);
  }
  const auto image = drawSheet(reader->scene(), *frames);
  if (!image) return console.fail(image.problems);
  const PngOptions png{.small = true, .text = pngText(reader->scene()), .dpi = sheetDpi};
  const auto written = writePng(options.output, *image, png);
  if (!written) return console.fail(written.problems);
  console.say(fmt::format("{}: {} times, {} x {} pixels", options.output, frames->size(), image->size.width,
                          image->size.height));
  return ExitCode::done;
}

}  // namespace

void addSheetCommand(CLI::App& program, CommandContext context) {
  CLI::App* command = program.add_subcommand("sheet", "Contact sheet of a run at several times, for print");
  auto options = std::make_shared<SheetOptions>();
  command->add_option("run", options->run, "Folder of a run, or its trajectory.h5")
      ->required()
      ->type_name("RUN");
  command->add_option("-o,--output", options->output, "The picture")->required()->type_name("FILE.png");
  command->add_option("--times", options->times, "Simulated seconds; 0, 0.5, 1, 2, 3, ... by default")
      ->type_name("T,T,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  addGlOption(*command);
  command->footer("Example:\n  bedmix sheet out/even -o sheet.png --times 0,0.5,1,2,3,4,5,6,7");
  command->callback([options, context] { context.outcome = sheet(*options, context.console); });
}

}  // namespace bedmix
