// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/console.h"
#include "app/version.h"
#include "engine/core/near_miss.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <new>
#include <unistd.h>

namespace bedmix {

namespace {

/// What CLI11 objects to, with the command that was probably meant where the first word is none.
std::string usageProblem(const CLI::App& program, const CLI::ParseError& error, int argc, char** argv) {
  const CLI::App* command = nullptr;
  std::vector<std::string> names;
  for (const CLI::App* known : program.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(known->get_name());
    if (argc > 1 && known->get_name() == argv[1]) command = known;
  }
  if (argc > 1 && !command && argv[1][0] != '-')
    return fmt::format("there is no command \"{}\" (see bedmix --help){}", argv[1],
                       didYouMean(argv[1], names));
  return fmt::format("{}; see bedmix {}--help", error.what(), command ? command->get_name() + " " : "");
}

/// Where a standard stream is closed, the next file to be opened would take its place, and with it all that
/// is said.
void openStandardStreams() {
  int descriptor = 0;
  do descriptor = open("/dev/null", O_RDWR);
  while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  close(descriptor);
}

int run(int argc, char** argv) {
  openStandardStreams();
  std::signal(SIGPIPE, SIG_IGN);  // a reader of stdout that leaves must not end a simulation,
  std::signal(SIGXFSZ, SIG_IGN);  // and a file that may not grow is a failed write like any other

  Console console;
  ExitCode outcome = ExitCode::done;
  CLI::App program(
      "bedmix: mixing in gas-fluidized beds, simulated (CFD-DEM), drawn without a display, replayed");
  program.name("bedmix");
  program.set_version_flag("--version", fmt::format("bedmix {} ({})", programVersion, programCommit));
  program.add_flag("-q,--quiet", console.quiet, "Say nothing but errors");
  program.require_subcommand(1);
  program.fallthrough();
  program.footer(
      "Start with:\n  bedmix run tian-2007-even -o out/even --video\n"
      "Exit codes: 0 done, 2 usage or invalid scene, 3 solution became invalid, 4 file or disk trouble,\n"
      "5 rendering or encoding unavailable, 130 stopped by a signal after a clean flush and checkpoint.");

  const CommandContext context{console, outcome};
  addRunCommand(program, context);
  addReplayCommand(program, context);
  addRenderCommand(program, context);
  addSheetCommand(program, context);
  addPlotCommand(program, context);
  addReportCommand(program, context);
  addExportCommand(program, context);
  addRecoverCommand(program, context);
  addViewCommand(program, context);
  addAccuracyCommand(program, context);
  addCheckCommand(program, context);
  addScenesCommand(program, context);
  addDoctorCommand(program, context);
  addCompletionCommand(program, context);

  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {  // --help and --version
    program.exit(help);
  } catch (const CLI::ParseError& error) {
    outcome = console.fail("", usageProblem(program, error, argc, argv));
  } catch (const std::filesystem::filesystem_error& error) {
    outcome = console.fail(error.path1().string(), error.code().message(), Trouble::file);
  } catch (const std::bad_alloc&) {
    outcome = console.fail("", "not enough memory; take fewer particles, cells or pixels");
  }
  return static_cast<int>(outcome);
}

}  // namespace

}  // namespace bedmix

int main(int argc, char** argv) { return bedmix::run(argc, argv); }
