// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/progress.h"
#include "app/replay_job.h"
#include "app/run_folder.h"
#include "app/verification.h"
#include "app/version.h"
#include "engine/core/thread_team.h"
#include "replay/csv.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>
#include <utility>

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace bedmix {

namespace {

struct ReplayOptions {
  std::vector<std::string> runs;
  std::string folder;
  RecordingOptions recording;
  ReplaySettings settings;
  const CLI::Option* from = nullptr;  // whether it was given
  bool verify = false;
  bool json = false;
};

Json toJson(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

/// The tables of a replay by their names, each as its columns.
Result<Json> seriesOf(const Replayed& replayed) {
  Json series = Json::object();
  for (const std::string& name : replayed.series) {
    const auto table = readCsv(replayed.folder / (name + ".csv"));
    if (!table) return table.problems;
    Json columns = Json::object();
    for (std::size_t c = 0; c < table->names.size(); ++c) {
      Json& column = columns[table->names[c]] = Json::array();
      for (const auto& value : table->columns[c]) column.push_back(toJson(value));
    }
    series[name] = std::move(columns);
  }
  return series;
}

Result<Json> toJson(const RecordedRun& run, const Replayed& replayed) {
  auto series = seriesOf(replayed);
  if (!series) return series.problems;
  Json findings = Json::object();
  for (const FoundNumber& f : replayed.findings)
    findings[f.name] = {{"value", toJson(f.value)}, {"unit", f.unit}};
  return Json{{"folder", replayed.folder.string()},
              {"scene", run.scene().name},
              {"frames", replayed.frames},
              {"from", replayed.from},
              {"to", replayed.to},
              {"findings", std::move(findings)},
              {"series", std::move(*series)}};
}

/// Where the series of each run go: several runs share a folder by their names.
std::vector<fs::path> foldersOf(const ReplayOptions& options, std::span<const RecordedRun> runs) {
  std::vector<fs::path> folders;
  for (const RecordedRun& run : runs)
    if (options.folder.empty())
      folders.push_back(run.replayFolder());
    else
      folders.push_back(runs.size() == 1 ? fs::path(options.folder) : fs::path(options.folder) / run.name);
  return folders;
}

/// Replays them side by side, as many at once as there are cores. The results stand in the order of the runs.
std::vector<Result<Replayed>> replayAll(const ReplayOptions& options, std::span<RecordedRun> runs,
                                        const Console& console) {
  const std::vector<fs::path> folders = foldersOf(options, runs);
  std::vector<Result<Replayed>> results(runs.size(), Replayed{});
  if (runs.size() == 1) {
    Progress progress(console, std::min(options.settings.frames.to, runs.front().end()));
    results.front() = replayRun(runs.front(), options.settings, folders.front(), &progress);
    return results;
  }
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i; (i = next++) < runs.size();)
      results[i] = replayRun(runs[i], options.settings, folders[i]);
  };
  std::vector<std::jthread> threads;
  for (std::size_t t = 1; t < std::min<std::size_t>(runs.size(), static_cast<std::size_t>(availableCores()));
       ++t)
    threads.emplace_back(work);
  work();
  threads.clear();  // joins
  return results;
}

ExitCode replay(const ReplayOptions& options, const Console& console) {
  auto runs = openRuns(options.runs, options.recording);
  if (!runs) return console.fail(runs.problems);
  for (const RecordedRun& run : *runs)
    for (const RunEvent& event : run.reader->events())
      console.say(fmt::format("{}: at {:g} s: {} {}", run.name, event.time, event.kind, event.detail));

  const std::vector<Result<Replayed>> results = replayAll(options, *runs, console);
  ExitCode outcome = ExitCode::done;
  Json all = Json::array();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto told = results[i] ? toJson((*runs)[i], *results[i]) : Result<Json>(results[i].problems);
    if (!told) {
      outcome = console.fail(told.problems);
      continue;
    }
    all.push_back(*told);
    console.say(fmt::format("{} frames re-derived into {}", results[i]->frames, results[i]->folder.string()));
    for (const FoundNumber& f : results[i]->findings)
      console.say(fmt::format("  {} = {}{}{}", f.name,
                              f.value ? fmt::format("{:.4g}", *f.value) : "undefined",
                              f.unit.empty() ? "" : " ", f.unit));
  }
  if (options.json) console.print((all.size() == 1 ? all.front() : Json{{"runs", all}}).dump());
  return outcome;
}

Json toJson(const std::string& run, const Verification& done) {
  Json json{{"run", run},        {"same", !done.mismatch}, {"from", done.from},
            {"to", done.to},     {"frames", done.frames},  {"states", done.states},
            {"mismatch", Json()}};
  if (const auto& m = done.mismatch)
    json["mismatch"] = {{"step", m->step}, {"time", m->time}, {"what", m->what}};
  return json;
}

ExitCode verify(const ReplayOptions& options, const Console& console) {
  ExitCode outcome = ExitCode::done;
  Json all = Json::array();
  const std::optional<double> from =
      options.from->count() > 0 ? std::optional(options.settings.frames.from) : std::nullopt;
  for (const std::string& run : options.runs) {
    const auto done = verifyRun(run, from);
    if (!done) {
      outcome = console.fail(done.problems);
      continue;
    }
    all.push_back(toJson(run, *done));
    const std::string program = fmt::format("{} ({})", programVersion, programCommit);
    if (const auto& m = done->mismatch)
      outcome =
          console.fail(run,
                       fmt::format("step {} at {:g} s is the first that is another when it is computed "
                                   "again: {}{}",
                                   m->step, m->time, m->what,
                                   program == done->program
                                       ? ""
                                       : fmt::format("; it was recorded by bedmix {}, this is {}, whose "
                                                     "results may be others",
                                                     done->program, program)),
                       Trouble::file);
    else
      console.say(
          fmt::format("{}: {} frames from {:g} to {:g} s and {} double states are the same to the bit", run,
                      done->frames, done->from, done->to, done->states));
  }
  if (options.json) console.print((all.size() == 1 ? all.front() : Json{{"runs", all}}).dump());
  return outcome;
}

template <class Kinds>
std::string namesOf(const Kinds& kinds) {
  std::vector<std::string_view> names;
  for (const auto& kind : kinds) names.push_back(kind.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

void addReplayCommand(CLI::App& program, CommandContext context) {
  CLI::App* command = program.add_subcommand("replay", "Re-derive all indices from recorded runs");
  auto options = std::make_shared<ReplayOptions>();
  ReplaySettings& settings = options->settings;
  command
      ->add_option("runs", options->runs, "Folders of runs, their trajectory.h5, or files of other programs")
      ->required()
      ->type_name("RUN...");
  command
      ->add_option("-o,--output", options->folder,
                   "Folder of the series, with several runs one of each in it; RUN/replay by default")
      ->type_name("DIR");
  command->add_option("--sampling", settings.sampling, "Sampling cells, in place of the scene's")
      ->type_name("CxR");
  command->add_option("--min-particles", settings.minParticles, "Cells with fewer particles are not used")
      ->type_name("N");
  command
      ->add_option(
          "--tracer", settings.tracer,
          fmt::format("Tag the particles anew: {}, strips=N, layers=N, or an expression of x, y, vx, vy, "
                      "id, species, width, height, e.g. \"x < width/3 && y > 0.02\"",
                      namesOf(modelTable<TracerRule>)))
      ->type_name("RULE");
  command
      ->add_option("--tracer-at", settings.tracerAt,
                   "The tracer is chosen then; at the first frame by default")
      ->type_name("T");
  addFrameSelection(*command, settings.frames);
  addRecordingOptions(*command, options->recording);
  options->from = command->get_option("--from");
  command
      ->add_option("--analysis", settings.analyses,
                   "Derive more, each into a table of its own: all, or some of " + namesOf(analysisKinds()))
      ->type_name("NAMES");
  command
      ->add_option("--line", settings.lines,
                   "Solids flux through the line between two points, m; may be repeated")
      ->type_name("X0,Y0,X1,Y1")
      ->delimiter(',')
      ->type_size(4)
      ->allow_extra_args(false);
  command->add_flag(
      "--verify", options->verify,
      "Compute the run again instead, from its oldest checkpoint or --from T on, and compare every "
      "frame and state to the bit");
  command->add_flag("--json", options->json, "Print what was found, and the series, as JSON");
  command->footer(
      "Examples:\n  bedmix replay out/even -o out/even-8x30 --sampling 8x30 --min-particles 6\n"
      "  bedmix replay out/even --analysis all --json\n"
      "  bedmix replay out/even --verify --from 0");
  command->callback([options, context] {
    context.outcome = options->verify ? verify(*options, context.console) : replay(*options, context.console);
  });
}

}  // namespace bedmix
