// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/resume.h"
#include "app/run_folder.h"
#include "app/version.h"
#include "replay/recover.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

struct RecoverOptions {
  std::string file;
  std::string output;
  bool json = false;
};

bool canResume(std::span<const std::byte> checkpoint, const Scene& scene, std::size_t frames) {
  const auto mark = checkpointMark(checkpoint);
  return mark && framesUntil(*mark, scene) <= frames;
}

std::string account(const Recovery& found) {
  return fmt::format("{} of {} frames, up to {:g} s, and {} checkpoint{}", found.frames, found.recorded,
                     found.until, found.checkpoints, found.checkpoints == 1 ? "" : "s");
}

ExitCode recoverFile(const RecoverOptions& options, const Console& console) {
  fs::path file = options.file;
  if (fs::is_directory(file)) file = RunFolder{file}.trajectory();
  fs::path output = options.output;
  if (output.empty())
    output = file.parent_path() / (file.stem().string() + "-recovered" + file.extension().string());
  else if (output.has_parent_path())
    if (const auto folder = makeFolder(output.parent_path()); !folder) return console.fail(folder.problems);

  const auto found = recover(file, output, canResume, {programVersion, programCommit});
  if (!found) return console.fail(found.problems);
  if (found->damage) {
    console.warn(toString(*found->damage));
    console.say(fmt::format("{}: saved {}", output.string(), account(*found)));
  } else {
    console.say(fmt::format("{}: is sound, nothing to repair; it holds {}", file.string(), account(*found)));
  }
  if (options.json) {
    nlohmann::ordered_json result = {{"file", file.string()},
                                     {"sound", !found->damage},
                                     {"output", nullptr},
                                     {"frames", found->frames},
                                     {"recorded", found->recorded},
                                     {"until", found->until},
                                     {"checkpoints", found->checkpoints},
                                     {"damage", nullptr}};
    if (found->damage) {
      result["output"] = output.string();
      result["damage"] = found->damage->message;
    }
    console.print(result.dump(2));
  }
  return ExitCode::done;
}

}  // namespace

void addRecoverCommand(CLI::App& program, CommandContext context) {
  CLI::App* command = program.add_subcommand("recover", "Save what is left of a damaged trajectory");
  auto options = std::make_shared<RecoverOptions>();
  command->add_option("file", options->file, "A trajectory.h5, or the folder of a run; it stays as it is")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("-o,--output", options->output,
                   "File to write, which must not be there; FILE with -recovered by default")
      ->type_name("OUT");
  command->add_flag("--json", options->json, "Print what was found as JSON");
  command->footer("Example:\n  bedmix recover out/even/trajectory.h5 -o out/saved/trajectory.h5");
  command->callback([options, context] { context.outcome = recoverFile(*options, context.console); });
}

}  // namespace bedmix
