// SPDX-License-Identifier: MIT
#include "app/accuracy/diagrams.h"
#include "app/accuracy/findings.h"
#include "app/accuracy/study.h"
#include "app/accuracy/tables.h"
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/scene_library.h"
#include "app/version.h"
#include "engine/core/hash.h"
#include "engine/core/thread_team.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <limits>
#include <memory>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

struct AccuracyOptions {
  std::string scene;
  std::string folder;
  double budget = std::numeric_limits<double>::infinity();
  int runs = usualRuns;
  bool resume = false;
};

/// Makes the folder of the study. One that holds anything is refused but to resume.
Result<fs::path> studyFolder(const AccuracyOptions& options, const Scene& scene) {
  fs::path path = options.folder.empty() ? "out/accuracy-" + scene.name : options.folder;
  std::error_code error;
  fs::create_directories(path, error);
  if (error) return Diagnostic{{path.string()}, "cannot make this folder: " + error.message(), Trouble::file};
  if (!options.resume && !fs::is_empty(path, error))
    return Diagnostic{
        {path.string()},
        "this folder is not empty; give another with -o, or --resume to go on with the study in it"};
  return path;
}

std::string fingerprint(const Scene& scene) {
  StateHash hash;
  for (const char c : writeScene(scene)) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  return fmt::format("{:016x}", hash.value());
}

ExitCode accuracy(const AccuracyOptions& options, const Console& console) {
  const auto scene = loadScene(options.scene);
  if (!scene) return console.fail(scene.problems);
  const auto planned = designFor(*scene);
  if (!planned) return console.fail(planned.problems);
  const Design& design = *planned;
  const auto folder = studyFolder(options, *scene);
  if (!folder) return console.fail(folder.problems);
  auto log = SampleLog::open(*folder / "accuracy.csv", fmt::format("{} ({})", programVersion, programCommit),
                             fingerprint(*scene), options.resume);
  if (!log) return console.fail(log.problems);

  catchInterrupts();
  Study study(*scene, design, *log, console, {options.budget, availableCores(), options.runs, stopRequested});
  if (const auto problem = study.run()) return console.fail(*problem);
  for (const std::string& what : study.plan().dropped) console.say("dropped, for the budget: " + what);
  if (study.samplesLeft() > 0)
    console.warn(fmt::format("{} samples were not taken; bedmix accuracy --resume goes on with them",
                             study.samplesLeft()));
  const Findings findings(design, log->samples(), study.plan().duration);
  console.print(tablesOf(design, findings));
  console.print(verdictOf(design, findings));
  if (const auto drawn = drawDiagrams(*folder, design, findings); !drawn) return console.fail(drawn.problems);
  console.say(fmt::format("samples and diagrams are in {}", folder->string()));
  return stopRequested() ? ExitCode::stopped : ExitCode::done;
}

}  // namespace

void addAccuracyCommand(CLI::App& program, CommandContext context) {
  CLI::App* command = program.add_subcommand("accuracy", "Show what accuracy costs in time, for a scene");
  auto options = std::make_shared<AccuracyOptions>();
  command->add_option("scene", options->scene, "Scene file, or the name of a bundled scene")
      ->required()
      ->type_name("SCENE");
  command->add_option("-o,--output", options->folder, "Folder of the study; out/accuracy-<scene> by default")
      ->type_name("DIR");
  command
      ->add_option("--budget", options->budget,
                   "Wall seconds; says what it drops, statistics of all but the presets first")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--runs", options->runs,
                   "Runs of each preset that statistics are taken from, each from its own seed; more tell "
                   "smaller differences from noise")
      ->type_name("N")
      ->check(CLI::Range(2, 10000))
      ->capture_default_str();
  command->add_flag("--resume", options->resume,
                    "Go on with the study in the folder; finished samples are kept");
  command->footer("Example:\n  bedmix accuracy tian-2007-even -o out/price --budget 900");
  command->callback([options, context] { context.outcome = accuracy(*options, context.console); });
}

}  // namespace bedmix
