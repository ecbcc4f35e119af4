// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/frame_selection.h"
#include "app/gl_option.h"
#include "app/interrupt.h"
#include "app/picture_options.h"
#include "app/render_job.h"
#include "render/film_kind.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

constexpr double defaultRate = 50.0;  // pictures a second

struct RenderOptions {
  std::vector<std::string> runs;
  RecordingOptions recording;
  std::string output;
  std::optional<double> time;  // s
  std::optional<double> fps, speed;
  FrameSelection frames;
  PictureOptions picture;
  bool force = false;
};

enum class Output { film, picture, folder };

/// By the ending of its name.
Result<Output> outputOf(const std::string& name) {
  const fs::path path = name;
  if (filmKindOf(path)) return Output::film;
  if (path.extension() == ".png") return Output::picture;
  if (path.extension().empty()) return Output::folder;
  return Diagnostic{{"--output"},
                    fmt::format("\"{}\" is no kind of picture; give a .mp4, .gif or .mkv film, a .png "
                                "picture or a folder for single frames",
                                name)};
}

/// Options that say nothing of this kind of output.
std::vector<Diagnostic> misplaced(const RenderOptions& options, Output output) {
  std::vector<Diagnostic> problems;
  if (options.time && output != Output::picture)
    problems.push_back(
        {{"--time"}, "goes with one picture, -o FILE.png; a film and a folder take --from and --to"});
  if ((options.fps || options.speed) && output != Output::film)
    problems.push_back(
        {{"--fps, --speed"}, "go with a film; a folder has each frame once, or with --every N each N-th"});
  if (options.frames != FrameSelection{} && output == Output::picture)
    problems.push_back({{"--from, --to, --every"}, "go with a film or a folder; one picture takes --time"});
  if (options.force && output != Output::folder)
    problems.push_back(
        {{"--force"},
         "goes with a folder; a file of this name is replaced anyway, once the new one is complete"});
  return problems;
}

/// Index of the frame that a run shows at a time, by default its last.
Result<std::vector<std::size_t>> framesShownAt(const RecordedRun& run, std::optional<double> time) {
  auto found = framesAt(run.reader->times(), std::array{time.value_or(run.end())});
  if (!found)
    for (Diagnostic& d : found.problems) d.at.file = "--time";
  return found;
}

ExitCode render(const RenderOptions& options, const Console& console) {
  const auto output = outputOf(options.output);
  if (!output) return console.fail(output.problems);
  if (const auto problems = misplaced(options, *output); !problems.empty()) return console.fail(problems);
  auto runs = openRuns(options.runs, options.recording);
  if (!runs) return console.fail(runs.problems);
  RenderJob job{*runs, {}, options.output, {}, console};
  for (const RecordedRun& run : *runs) {
    const auto paint = paintOptions(options.picture, run.scene());
    if (!paint) return console.fail(paint.problems);
    if (job.selected.empty()) job.paint = *paint;
    auto selected = *output == Output::picture ? framesShownAt(run, options.time)
                                               : selectFrames(run.reader->times(), options.frames);
    if (!selected) return console.fail(selected.problems);
    job.selected.push_back(std::move(*selected));
  }
  catchInterrupts();
  if (*output == Output::picture) return renderPicture(job);
  return *output == Output::folder
             ? renderFolder(job, options.force)
             : renderFilm(job, options.fps.value_or(defaultRate), options.speed.value_or(1.0));
}

}  // namespace

void addRenderCommand(CLI::App& program, CommandContext context) {
  CLI::App* command =
      program.add_subcommand("render", "Draw recorded runs: a film, one picture or a folder of frames");
  auto options = std::make_shared<RenderOptions>();
  command
      ->add_option("runs", options->runs,
                   "Folders of runs, or their trajectory.h5; several are drawn side by side")
      ->required()
      ->type_name("RUN...");
  command
      ->add_option("-o,--output", options->output,
                   "FILE.mp4, .gif or .mkv (lossless) for a film, FILE.png for one picture, a folder for "
                   "single frames")
      ->required()
      ->type_name("X");
  command->add_option("--time", options->time, "Simulated second of the one picture; the last by default")
      ->type_name("T");
  addPictureOptions(*command, options->picture);
  addGlOption(*command);
  addRecordingOptions(*command, options->recording);
  command
      ->add_option("--fps", options->fps,
                   fmt::format("Pictures per second of film, {:g} by default", defaultRate))
      ->check(CLI::Range(1.0, 240.0));
  command->add_option("--speed", options->speed, "Simulated seconds per second of film, 1 by default")
      ->check(CLI::Range(1e-6, 1e6));
  addFrameSelection(*command, options->frames);
  command->add_flag("--force", options->force, "Replace the frames of another rendering in the folder");
  command->footer(
      "Examples:\n"
      "  bedmix render out/even -o even.mp4 --speed 0.5\n"
      "  bedmix render out/even out/inclined -o both.mp4 --layers particles,walls,hud,curve --size 1280x720\n"
      "  bedmix render out/even -o even.gif --size 320x560 --fps 20 --to 2\n"
      "  bedmix render out/even -o even-1s.png --time 1 --layers particles,velocity,sampling,walls,hud\n"
      "  bedmix render out/even -o strips.png --time 1 --color strips:6 --background black");
  command->callback([options, context] { context.outcome = render(*options, context.console); });
}

}  // namespace bedmix
