// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/frame_selection.h"
#include "app/recorded_runs.h"
#include "app/run_folder.h"
#include "replay/export/export_format.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

struct ExportOptions {
  std::string run;
  RecordingOptions recording;
  std::string format;
  std::string folder;
  FrameSelection frames;
  bool json = false;
};

/// Problems of an option of the command line.
template <class T>
ExitCode failAt(const char* option, Result<T>& result, const Console& console) {
  for (Diagnostic& d : result.problems) d.at.file = option;
  return console.fail(result.problems);
}

ExitCode exportRun(const ExportOptions& options, const Console& console) {
  auto format = findExportFormat(options.format);
  if (!format) return failAt("--to", format, console);
  auto runs = openRuns(std::span(&options.run, 1), options.recording);
  if (!runs) return console.fail(runs.problems);
  RecordedFrames* const reader = runs->front().reader.get();
  auto selected = selectFrames(reader->times(), options.frames);
  if (!selected) return failAt("--from/--until", selected, console);
  const auto folder = makeFolder(options.folder);
  if (!folder) return console.fail(folder.problems);

  const RunFolder run{runFolderOf(options.run)};
  const fs::path trajectory = fs::is_directory(options.run) ? run.trajectory() : fs::path(options.run);
  auto made = (*format)->open({reader->scene(), trajectory, reader->times().size(), *selected, folder->path,
                               runs->front().isForeign});
  if (!made) return console.fail(made.problems);
  Export& sink = **made;
  for (const std::size_t index : *selected) {
    const auto frame = reader->frame(index);
    if (!frame) return console.fail(frame.problems);
    sink.accept(**frame);
    if (sink.failure()) return console.fail(*sink.failure());
  }

  std::vector<std::string> files;
  for (const fs::path& file : sink.files()) files.push_back(file.string());
  console.say(
      fmt::format("{} frames for {} in {}", selected->size(), (*format)->programs, fmt::join(files, ", ")));
  if (options.json) {
    const nlohmann::ordered_json result = {{"format", options.format},
                                           {"files", files},
                                           {"frames", selected->size()},
                                           {"from", reader->times()[selected->front()]},
                                           {"until", reader->times()[selected->back()]}};
    console.print(result.dump());
  }
  return ExitCode::done;
}

}  // namespace

void addExportCommand(CLI::App& program, CommandContext context) {
  CLI::App* command = program.add_subcommand("export", "Write a recorded run in another program's format");
  auto options = std::make_shared<ExportOptions>();
  command->add_option("run", options->run, "Folder of a run, its trajectory.h5, or a file of another program")
      ->required()
      ->type_name("RUN");
  std::string formats;
  for (const ExportFormat& f : exportFormats())
    formats += fmt::format("{}{} ({})", formats.empty() ? "" : ", ", f.name, f.programs);
  command->add_option("--to", options->format, formats)->required()->type_name("FORMAT");
  command->add_option("-o,--output", options->folder, "Folder to write into; nothing in it is overwritten")
      ->required()
      ->type_name("DIR");
  addFrameSelection(*command, options->frames, "--until");
  addRecordingOptions(*command, options->recording);
  command->add_flag("--json", options->json, "Print what was written as JSON");
  command->footer("Example:\n  bedmix export out/even --to vtk -o out/even-vtk");
  command->callback([options, context] { context.outcome = exportRun(*options, context.console); });
}

}  // namespace bedmix
