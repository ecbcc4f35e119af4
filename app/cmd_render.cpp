// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/frame_selection.h"
#include "app/gl_option.h"
#include "app/picture_options.h"
#include "app/png_text.h"
#include "app/progress.h"
#include "render/film_sink.h"
#include "render/sheet.h"
#include "replay/trajectory_reader.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <functional>
#include <memory>
#include <optional>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

struct RenderOptions {
  std::string run;
  std::string output;
  std::optional<double> time;  // s
  double fps = 50.0, speed = 1.0;
  FrameSelection frames;
  PictureOptions picture;
};

/// Hands on the selected frames of a run, saying how far it has come; the first trouble ends it.
Result<Done> forFrames(TrajectoryReader& reader, const std::vector<std::size_t>& selected,
                       const Console& console, const std::function<Result<Done>(const Frame&)>& use) {
  Progress progress(console, reader.times()[selected.back()]);
  for (const std::size_t index : selected) {
    const auto frame = reader.frame(index);
    if (!frame) return frame.problems;
    auto used = use(**frame);
    if (!used) return used;
    progress.accept(**frame);
  }
  return Done{};
}

ExitCode renderFilm(const RenderOptions& options, TrajectoryReader& reader,
                    const std::vector<std::size_t>& selected, const PaintOptions& paint,
                    const Console& console) {
  FilmOptions film{paint, options.fps, options.speed, reader.times()[selected.front()],
                   reader.times()[selected.back()]};
  auto sink = FilmSink::create(reader.scene(), options.output, film);
  if (!sink) return console.fail(sink.problems);
  const auto shown = forFrames(reader, selected, console, [&](const Frame& frame) -> Result<Done> {
    sink->accept(frame);
    return Done{};
  });
  if (!shown) return console.fail(shown.problems);
  const auto finished = sink->finish();
  if (!finished) return console.fail(finished.problems);
  console.say(fmt::format("{}: {} pictures at {:g} a second", options.output, sink->pictures(), options.fps));
  return ExitCode::done;
}

ExitCode renderFolder(const RenderOptions& options, TrajectoryReader& reader,
                      const std::vector<std::size_t>& selected, const PaintOptions& paint,
                      const Console& console) {
  auto painter = Painter::create(reader.scene(), paint);
  if (!painter) return console.fail(painter.problems);
  std::error_code error;
  fs::create_directories(options.output, error);
  if (error)
    return console.fail(options.output, "cannot make this folder: " + error.message(), Trouble::file);
  Image image;
  int n = 0;
  const auto drawn = forFrames(reader, selected, console, [&](const Frame& frame) -> Result<Done> {
    auto painted = painter->paint(frame, image);
    if (!painted) return painted;
    const fs::path file = fs::path(options.output) / fmt::format("frame_{:06}.png", n++);
    return writePng(file, image, {.text = pngText(reader.scene(), frame), .dpi = {}});
  });
  if (!drawn) return console.fail(drawn.problems);
  console.say(fmt::format("{}: {} pictures", options.output, n));
  return ExitCode::done;
}

ExitCode renderPicture(const RenderOptions& options, TrajectoryReader& reader, const PaintOptions& paint,
                       const Console& console) {
  FramesAt wanted({options.time.value_or(reader.times().back())});
  FrameSink* const sinks[]{&wanted};
  drain(reader, sinks);
  if (reader.failure()) return console.fail(*reader.failure());
  auto frames = wanted.frames();
  if (!frames) {
    for (Diagnostic& d : frames.problems) d.at.file = "--time";
    return console.fail(frames.problems);
  }
  auto painter = Painter::create(reader.scene(), paint);
  if (!painter) return console.fail(painter.problems);
  Image image;
  const Frame& frame = *frames->front();
  const auto painted = painter->paint(frame, image);
  if (!painted) return console.fail(painted.problems);
  const auto written =
      writePng(options.output, image, {.small = true, .text = pngText(reader.scene(), frame), .dpi = {}});
  if (!written) return console.fail(written.problems);
  console.say(fmt::format("{}: the bed at {:g} s, {} x {} pixels", options.output, frame.time,
                          image.size.width, image.size.height));
  return ExitCode::done;
}

ExitCode render(const RenderOptions& options, const Console& console) {
  const std::string ending = fs::path(options.output).extension().string();
  const bool isFolder = ending.empty();
  if (!isFolder && ending != ".mp4" && ending != ".png")
    return console.fail("--output",
                        fmt::format("\"{}\" is no kind of picture; give a .mp4 film, a .png picture or "
                                    "a folder for single frames",
                                    options.output));
  if (options.time && ending != ".png")
    return console.fail("--time",
                        "goes with one picture, -o FILE.png; a film and a folder take --from and --to");
  auto reader = TrajectoryReader::open(options.run);
  if (!reader) return console.fail(reader.problems);
  const auto paint = paintOptions(options.picture, reader->scene());
  if (!paint) return console.fail(paint.problems);
  if (ending == ".png") return renderPicture(options, *reader, *paint, console);
  const auto selected = selectFrames(reader->times(), options.frames);
  if (!selected) return console.fail(selected.problems);
  return isFolder ? renderFolder(options, *reader, *selected, *paint, console)
                  : renderFilm(options, *reader, *selected, *paint, console);
}

}  // namespace

void addRenderCommand(CLI::App& program, CommandContext context) {
  CLI::App* command =
      program.add_subcommand("render", "Draw a recorded run: a film, one picture or a folder of frames");
  auto options = std::make_shared<RenderOptions>();
  command->add_option("run", options->run, "Folder of a run, or its trajectory.h5")
      ->required()
      ->type_name("RUN");
  command
      ->add_option("-o,--output", options->output,
                   "FILE.mp4 for a film, FILE.png for one picture, a folder for single frames")
      ->required()
      ->type_name("X");
  command->add_option("--time", options->time, "Simulated second of the one picture; the last by default")
      ->type_name("T");
  addPictureOptions(*command, options->picture);
  addGlOption(*command);
  command->add_option("--fps", options->fps, "Pictures per second of film")
      ->check(CLI::Range(1.0, 240.0))
      ->capture_default_str();
  command->add_option("--speed", options->speed, "Simulated seconds per second of film")
      ->check(CLI::Range(1e-6, 1e6))
      ->capture_default_str();
  addFrameSelection(*command, options->frames);
  command->footer(
      "Examples:\n"
      "  bedmix render out/even -o even.mp4 --speed 0.5\n"
      "  bedmix render out/even -o even-1s.png --time 1 --layers particles,velocity,sampling,walls,hud");
  command->callback([options, context] { context.outcome = render(*options, context.console); });
}

}  // namespace bedmix
