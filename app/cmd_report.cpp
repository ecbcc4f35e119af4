// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/gl_option.h"
#include "app/report/report.h"
#include "app/run_folder.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace bedmix {

namespace {

struct ReportOptions {
  std::vector<std::string> runs;
  RecordingOptions recording;
  std::string folder;
};

ExitCode report(const ReportOptions& options, const Console& console) {
  auto runs = openRuns(options.runs, options.recording);
  if (!runs) return console.fail(runs.problems);
  const auto folder = makeFolder(options.folder);
  if (!folder) return console.fail(folder.problems);
  const auto written = writeReport(*runs, folder->path, console);
  return written ? ExitCode::done : console.fail(written.problems);
}

}  // namespace

void addReportCommand(CLI::App& program, CommandContext context) {
  CLI::App* command =
      program.add_subcommand("report", "All figures of runs, and one web page with everything inside");
  auto options = std::make_shared<ReportOptions>();
  command->add_option("runs", options->runs, "Folders of runs, or their trajectory.h5; several are compared")
      ->required()
      ->type_name("RUN...");
  command
      ->add_option("-o,--output", options->folder,
                   "Folder of the figures and of report.html; figures of the same names are replaced")
      ->required()
      ->type_name("DIR");
  addGlOption(*command);
  addRecordingOptions(*command, options->recording);
  command->footer(
      "Examples:\n  bedmix report out/even -o out/even-report\n"
      "  bedmix report out/even out/inclined -o out/both");
  command->callback([options, context] { context.outcome = report(*options, context.console); });
}

}  // namespace bedmix
