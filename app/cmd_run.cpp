// SPDX-License-Identifier: MIT
#include "app/attempts.h"
#include "app/commands.h"
#include "app/gl_option.h"
#include "app/interrupt.h"
#include "app/run_report.h"
#include "app/scene_library.h"
#include "app/version.h"
#include "engine/core/particle_list.h"
#include "engine/core/presets.h"
#include "engine/core/refinement.h"
#include "engine/core/simd.h"
#include "engine/core/thread_team.h"
#include "replay/summary.h"
#include "replay/trajectory_reader.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>

namespace bedmix {

namespace {

constexpr const char *automatic = "auto", *stop = "stop", *retry = "retry";

struct RunOptions {
  std::string scene;
  std::string folder;
  std::optional<std::string> accuracy;     // a preset
  std::optional<std::string> until, seed;  // as TOML
  std::vector<std::string> settings;       // path=value
  std::string threads = automatic, simd = automatic;
  std::string onTrouble = stop;
  double checkpointSeconds = CheckpointSchedule{}.wallSeconds;
  bool video = false, force = false, resume = false, json = false;
};

Result<std::vector<Override>> overridesOf(const RunOptions& options) {
  std::vector<Override> overrides;
  if (options.accuracy) overrides = accuracyOverrides(*options.accuracy);
  const auto settings = settingOverrides(options.settings);
  if (!settings) return settings.problems;
  overrides.insert(overrides.end(), settings->begin(), settings->end());
  if (options.until) overrides.push_back({"time.duration", *options.until, "--until"});
  if (options.seed) overrides.push_back({"seed", *options.seed, "--seed"});
  return overrides;
}

/// What is wrong with --threads; empty where nothing is.
std::string threadsProblem(const std::string& text) {
  int threads = 0;
  const char* const last = text.data() + text.size();
  const bool number = std::from_chars(text.data(), last, threads).ptr == last;
  return (number && threads >= 1 && threads <= 256) || text == automatic
             ? ""
             : text + " is neither auto nor a number from 1 to 256";
}

/// A film takes a core of its own, unless all are asked for.
int solverThreads(const RunOptions& options, const Scene& scene) {
  if (options.threads != automatic) return std::stoi(options.threads);
  return threadsFor(mostParticles(scene), availableCores() - (options.video ? 1 : 0));
}

/// The cores the solver leaves over, at least one.
int paintThreads(int solverThreads) { return std::max(1, availableCores() - solverThreads); }

std::vector<std::string> simdChoices() {
  std::vector<std::string> choices{automatic};
  choices.insert(choices.end(), simdLevelNames().begin(), simdLevelNames().end());
  return choices;
}

/// False where this machine lacks the level.
bool chooseVectors(const std::string& level) {
  return level == automatic || useSimdLevel(*simdLevelNamed(level));
}

/// Where the run in the folder is gone on with.
Result<ResumePoint> findPoint(const RunPlan& plan, const Console& console) {
  auto recorded = TrajectoryReader::open(plan.folder.path);
  if (!recorded) return recorded.problems;
  const Provenance before = recorded->provenance();
  auto point = findResumePoint(std::move(*recorded), plan.scene, plan.threads, console);
  if (point && before != Provenance{programVersion, programCommit})
    console.warn(
        fmt::format("the run was begun by bedmix {} ({}), this is {} ({}); results may differ from those "
                    "without a break",
                    before.version, before.commit, programVersion, programCommit));
  return point;
}

/// Says why the solution is invalid and what is left.
ExitCode failInvalid(const RunOptions& options, const RunPlan& plan, const RunOutcome& outcome,
                     const Console& console) {
  std::string message = outcome.end.message;
  if (!outcome.retries.empty())
    message += fmt::format("; {} retries did not help, the last from {:g} s with {}", outcome.retries.size(),
                           outcome.retries.back().from, settingsText(outcome.retries.back().settings));
  console.fail(options.scene, message, Trouble::solution);
  if (outcome.end.lastCheckpoint)
    console.say(fmt::format("everything up to there is in {}; its last checkpoint is that at {:g} s",
                            plan.folder.path.string(), *outcome.end.lastCheckpoint));
  return ExitCode::invalidSolution;
}

/// Writes the summary and says how it came out.
ExitCode conclude(const RunOptions& options, const RunPlan& plan, const RunOutcome& outcome,
                  const Console& console) {
  ExitCode code = ExitCode::done;
  if (!outcome.filmProblems.empty()) {
    code = console.fail(outcome.filmProblems);
    console.warn("the run has no film");
  }
  const RunEnd& end = outcome.end;
  const RunSummary summary = summarize(plan, outcome);
  auto failure = outcome.failure;
  if (const auto trouble = writeSummary(plan.folder.summary(), summary, plan.scene); trouble && !failure)
    failure = trouble;
  if (failure) return console.fail(*failure);
  reportSteps(console, plan.scene, end.report);
  if (options.json) {
    const auto text = readTextFile(plan.folder.summary());
    if (!text) return console.fail(text.problems);
    console.print(*text);
  }
  if (end.reason == EndReason::invalid) return failInvalid(options, plan, outcome, console);
  console.say(fmt::format("{} {:g} simulated s in {:.3g} s ({:.3g} particle steps/s), {}",
                          end.reason == EndReason::stopped ? "stopped after" : "done:", end.simulatedSeconds,
                          end.wallSeconds, summary.particleStepsPerSecond, plan.folder.path.string()));
  return end.reason == EndReason::stopped ? ExitCode::stopped : code;
}

ExitCode run(const RunOptions& options, const Console& console) {
  const auto overrides = overridesOf(options);
  if (!overrides) return console.fail(overrides.problems);
  const auto scene = loadScene(options.scene, *overrides);
  if (!scene) return console.fail(scene.problems);
  if (!chooseVectors(options.simd))
    return console.fail("--simd " + options.simd,
                        fmt::format("this machine lacks it; it has {}", fmt::join(simdLevelsHere(), ", ")));
  const int threads = solverThreads(options, *scene);
  const std::string path = options.folder.empty() ? "out/" + scene->name : options.folder;
  const auto folder = options.resume ? claimRunFolder(path) : makeRunFolder(path, options.force);
  if (!folder) return console.fail(folder.problems);

  RunPlan plan{.scene = *scene,
               .folder = *folder,
               .threads = threads,
               .schedule = {.wallSeconds = options.checkpointSeconds},
               .film = {},
               .retries = options.onTrouble == retry};
  if (options.video) plan.film.emplace().paint = {{}, styleOf(*scene), paintThreads(threads)};

  std::optional<ResumePoint> point;
  if (options.resume) {
    auto found = findPoint(plan, console);
    if (!found) return console.fail(found.problems);
    point.emplace(std::move(*found));
    const Simulation& start = point->start.simulation;
    if (start.step() > totalSteps(point->scene)) {
      console.say(fmt::format("this run has come to {:g} s already; nothing to do", start.time()));
      return ExitCode::done;
    }
  }

  catchInterrupts();
  console.say(
      fmt::format("{} into {}", scene->title.empty() ? scene->name : scene->title, folder->path.string()));
  if (point)
    console.say(fmt::format("going on from {:g} s{}", point->start.simulation.time(),
                            point->scene.refinement == Refinement{}
                                ? ""
                                : " with " + settingsText(refinedSettings(point->scene))));
  else if (scene->start.arrangement == Arrangement::settled)
    console.say("settling the bed ...");
  const auto outcome = carryOut(plan, std::move(point), console);
  if (!outcome) return console.fail(outcome.problems);
  return conclude(options, plan, *outcome, console);
}

}  // namespace

void addRunCommand(CLI::App& program, CommandContext context) {
  CLI::App* command = program.add_subcommand("run", "Simulate a scene and record the run in a folder");
  auto options = std::make_shared<RunOptions>();
  command->add_option("scene", options->scene, "Scene file, or the name of a bundled scene")
      ->required()
      ->type_name("SCENE");
  command->add_option("-o,--output", options->folder, "Folder of the run; out/<scene> by default")
      ->type_name("DIR");
  command->add_option("--until", options->until, "Simulated seconds, in place of time.duration")
      ->type_name("T");
  command
      ->add_option("--accuracy", options->accuracy,
                   "Preset of the numerics, in place of the scene's: draft, standard, paper, reference")
      ->type_name("NAME");
  command->add_option("--seed", options->seed, "Seed of the random start, in place of the scene's")
      ->type_name("N");
  command
      ->add_option("--threads", options->threads,
                   "Threads of the solver, auto by the bed's size; they never change a result")
      ->type_name("N|auto")
      ->check(threadsProblem, "")
      ->capture_default_str();
  command
      ->add_option("--simd", options->simd,
                   "Vector instructions of the solver, auto the best there are; they never change a result")
      ->type_name("LEVEL")
      ->check(CLI::IsMember(simdChoices()))
      ->capture_default_str();
  command
      ->add_option("--set", options->settings,
                   "Change a key of the scene, e.g. gas.step=5e-5; an empty value removes it. Keys: bedmix "
                   "check --help")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--video", options->video, "Film the run into video.mp4 on the way");
  addGlOption(*command);
  CLI::Option* const force = command->add_flag("--force", options->force,
                                               "Replace an earlier run in the folder; other files are kept");
  command
      ->add_flag("--resume", options->resume,
                 "Go on with the run in the folder, however it ended, to the same result to the bit")
      ->excludes(force);
  command
      ->add_option(
          "--checkpoint", options->checkpointSeconds,
          "Wall seconds between checkpoints; there is one, too, each simulated second, at SIGUSR1 and "
          "when the run ends or is stopped")
      ->type_name("S")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--on-trouble", options->onTrouble,
                   fmt::format("What becomes of a solution that is invalid: stop, or retry from the last "
                               "checkpoint with half the step, up to {} times",
                               mostHalvings))
      ->type_name("stop|retry")
      ->check(CLI::IsMember({stop, retry}))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print summary.json at the end");
  command->footer(
      "Examples:\n  bedmix run tian-2007-even -o out/even --video --set particles.count=1180\n"
      "  bedmix run tian-2007-even -o out/even --resume --until 20");
  command->callback([options, context] { context.outcome = run(*options, context.console); });
}

}  // namespace bedmix
