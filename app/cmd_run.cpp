// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/resume.h"
#include "app/run_folder.h"
#include "app/scene_library.h"
#include "app/series.h"
#include "app/version.h"
#include "engine/core/presets.h"
#include "engine/core/simd.h"
#include "engine/core/thread_team.h"
#include "engine/worker.h"
#include "render/film_sink.h"
#include "replay/summary.h"
#include "replay/trajectory_reader.h"
#include "replay/trajectory_writer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>

namespace bedmix {

namespace {

constexpr const char* automatic = "auto";

struct RunOptions {
  std::string scene;
  std::string folder;
  std::optional<std::string> accuracy;     // a preset
  std::optional<std::string> until, seed;  // as TOML
  std::vector<std::string> settings;       // path=value
  std::string threads = automatic, simd = automatic;
  double checkpointSeconds = CheckpointSchedule{}.wallSeconds;
  bool video = false, force = false, resume = false, json = false;
};

/// All that is recorded of a run, open for writing.
struct Recording {
  Series series;
  std::optional<FilmSink> film;
  std::optional<TrajectoryWriter> trajectory;

  /// What is derived from frames.
  void derive(const Frame& frame) {
    for (const auto& file : series) file->accept(frame);
    if (film) film->accept(frame);
  }
  std::optional<Diagnostic> failure() const {
    if (trajectory && trajectory->failure()) return trajectory->failure();
    for (const auto& file : series)
      if (file->failure()) return file->failure();
    return std::nullopt;
  }
};

Result<std::vector<Override>> overridesOf(const RunOptions& options) {
  std::vector<Override> overrides;
  if (options.accuracy) overrides = accuracyOverrides(*options.accuracy);
  for (const std::string& setting : options.settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0)
      return Diagnostic{{"--set " + setting}, "must be path=value, e.g. --set gas.step=5e-5"};
    overrides.push_back({setting.substr(0, equals), setting.substr(equals + 1)});
  }
  if (options.until) overrides.push_back({"time.duration", *options.until, "--until"});
  if (options.seed) overrides.push_back({"seed", *options.seed, "--seed"});
  return overrides;
}

/// Makes the trajectory; or, to resume a run, derives everything anew from the frames recorded up to there
/// and opens it after them.
std::optional<Diagnostic> openTrajectory(Recording& recording, const RunFolder& folder, const Scene& scene,
                                         std::optional<TrajectoryReader> recorded, const ResumePoint* point) {
  if (recorded) {
    for (std::size_t i = 0; i < point->frames; ++i) {
      const auto frame = recorded->frame(i);
      if (!frame) return frame.problems.front();
      recording.derive(**frame);
      if (recording.failure()) return recording.failure();
    }
    recorded.reset();  // before the file is written
  }
  auto trajectory =
      point ? TrajectoryWriter::resume(folder.trajectory(), scene, point->frames, point->slot)
            : TrajectoryWriter::create(folder.trajectory(), scene, {programVersion, programCommit});
  if (!trajectory) return trajectory.problems.front();
  recording.trajectory.emplace(std::move(*trajectory));
  return std::nullopt;
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
  return threadsFor(scene.particles.count, availableCores() - (options.video ? 1 : 0));
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

/// Drains the solver into the recording until it ends, a stop is asked for or a file cannot be written.
void follow(Worker& worker, Recording& recording, Progress& progress) {
  while (const FramePtr frame = worker.next()) {
    recording.trajectory->accept(*frame);
    if (!recording.failure()) recording.derive(*frame);  // a row follows its frame
    const Checkpoint checkpoint = worker.checkpoint();
    if (checkpoint && !recording.failure()) recording.trajectory->keep(*checkpoint);
    progress.accept(*frame);
    if (checkpointRequested()) worker.requestCheckpoint();
    if (stopRequested() || recording.failure()) worker.requestStop();
  }
  recording.trajectory->finish();
}

RunSummary summarize(const Scene& scene, const RunEnd& end, int threads) {
  RunSummary s;
  s.scene = scene.name;
  s.seed = scene.seed;
  s.version = programVersion;
  s.commit = programCommit;
  s.simulatedSeconds = end.simulatedSeconds;
  s.wallSeconds = end.wallSeconds;
  s.steps = end.steps;
  s.gasSteps = end.gasSteps;
  if (end.wallSeconds > 0.0)
    s.particleStepsPerSecond =
        static_cast<double>(end.steps) * static_cast<double>(scene.particles.count) / end.wallSeconds;
  for (std::size_t i = 0; i < end.stages.size(); ++i) s.stages.emplace_back(stageNames[i], end.stages[i]);
  s.threads = threads;
  s.simd = simdLevelNames()[static_cast<std::size_t>(simdLevel())];
  s.stateHash = end.stateHash;
  s.endReason = end.reason == EndReason::finished  ? "finished"
                : end.reason == EndReason::stopped ? "stopped"
                                                   : "invalid";
  return s;
}

/// What a user should know of a run that ended well enough.
void reportSteps(const Console& console, const Scene& scene, const StepReport& report) {
  if (report.largestOverlap > scene.limits.warnOverlap)
    console.warn(
        fmt::format("the largest overlap was {:.2g} of a diameter (particle {}); raise contacts.stiffness",
                    report.largestOverlap, report.largestOverlapParticle));
  if (report.aboveGridLargest > 0)
    console.say(fmt::format("up to {} particles at a time were above the gas grid and fell without gas",
                            report.aboveGridLargest));
  if (report.largestCourant > 1.0)
    console.warn(
        fmt::format("gas passed {:.2g} cells in a step, where time is resolved below 1; lower gas.step",
                    report.largestCourant));
  if (report.gasStepsNotConverged > 0)
    console.warn(
        fmt::format("{} gas steps ended at the iteration limit; lower gas.step or raise gas.max_iterations",
                    report.gasStepsNotConverged));
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

  std::optional<TrajectoryReader> recorded;
  std::optional<ResumePoint> point;
  if (options.resume) {
    auto reader = TrajectoryReader::open(folder->path);
    if (!reader) return console.fail(reader.problems);
    recorded.emplace(std::move(*reader));
    auto found = findResumePoint(*recorded, *scene, threads, console);
    if (!found) return console.fail(found.problems);
    point.emplace(std::move(*found));
    if (const Provenance before = recorded->provenance(); before != Provenance{programVersion, programCommit})
      console.warn(
          fmt::format("the run was begun by bedmix {} ({}), this is {} ({}); results may differ from those "
                      "without a break",
                      before.version, before.commit, programVersion, programCommit));
    const Simulation& start = point->start.simulation;
    if (start.step() > totalSteps(*scene)) {
      console.say(fmt::format("this run has come to {:g} s already; nothing to do", start.time()));
      return ExitCode::done;
    }
  }

  auto series = openSeries(*folder, *scene);
  if (!series) return console.fail(series.problems);
  Recording recording{std::move(*series), {}, {}};
  ExitCode outcome = ExitCode::done;
  if (options.video) {
    FilmOptions film;
    film.paint.threads = paintThreads(threads);
    auto sink = FilmSink::create(*scene, folder->video(), film);
    if (sink) {
      recording.film.emplace(std::move(*sink));
    } else {
      outcome = console.fail(sink.problems);
      console.warn("the run goes on without its film");
    }
  }

  if (const auto failure =
          openTrajectory(recording, *folder, *scene, std::move(recorded), point ? &*point : nullptr))
    return console.fail(*failure);

  catchInterrupts();
  console.say(
      fmt::format("{} into {}", scene->title.empty() ? scene->name : scene->title, folder->path.string()));
  if (point)
    console.say(fmt::format("going on from {:g} s", point->start.simulation.time()));
  else if (scene->start.arrangement == Arrangement::settled)
    console.say("settling the bed ...");
  const CheckpointSchedule schedule{.wallSeconds = options.checkpointSeconds};
  Worker worker =
      point ? Worker(*scene, std::move(point->start), schedule) : Worker(*scene, threads, schedule);
  {
    Progress progress(console, scene->time.duration);
    follow(worker, recording, progress);
  }

  if (recording.film)
    if (const auto finished = recording.film->finish(); !finished) outcome = console.fail(finished.problems);
  const RunEnd& end = worker.end();
  const RunSummary summary = summarize(*scene, end, threads);
  auto fileFailure = recording.failure();
  if (const auto failure = writeSummary(folder->summary(), summary, *scene); failure && !fileFailure)
    fileFailure = failure;
  if (fileFailure) return console.fail(*fileFailure);
  reportSteps(console, *scene, end.report);
  if (options.json) {
    const auto text = readTextFile(folder->summary());
    if (!text) return console.fail(text.problems);
    console.print(*text);
  }
  if (end.reason == EndReason::invalid) {
    console.fail(options.scene, end.message);
    if (end.lastCheckpoint)
      console.say(fmt::format("everything up to there is in {}; its last checkpoint is that at {:g} s",
                              folder->path.string(), *end.lastCheckpoint));
    return ExitCode::invalidSolution;
  }
  console.say(fmt::format("{} {:g} simulated s in {:.3g} s ({:.3g} particle steps/s), {}",
                          end.reason == EndReason::stopped ? "stopped after" : "done:", end.simulatedSeconds,
                          end.wallSeconds, summary.particleStepsPerSecond, folder->path.string()));
  return end.reason == EndReason::stopped ? ExitCode::stopped : outcome;
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
  command->add_flag("--json", options->json, "Print summary.json at the end");
  command->footer(
      "Examples:\n  bedmix run tian-2007-even -o out/even --video --set particles.count=1180\n"
      "  bedmix run tian-2007-even -o out/even --resume --until 20");
  command->callback([options, context] { context.outcome = run(*options, context.console); });
}

}  // namespace bedmix
