// SPDX-License-Identifier: MIT
#include "app/commands.h"
#include "app/frame_selection.h"
#include "app/run_folder.h"
#include "app/series.h"
#include "engine/core/bed_statistics.h"
#include "engine/core/scene_keys.h"
#include "engine/core/scene_reader.h"
#include "replay/analysis/analysis.h"
#include "replay/trajectory_reader.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace fs = std::filesystem;

namespace bedmix {

namespace {

struct ReplayOptions {
  std::string run;
  std::string folder;
  std::string sampling;      // "CxR"
  std::string minParticles;  // as TOML
  std::string tracer;
  FrameSelection frames;
  std::string analyses;  // comma-separated
  bool json = false;
};

/// The scene of the run with what the options change in it.
Result<Scene> sceneFor(const ReplayOptions& options, const Scene& recorded) {
  std::vector<Override> overrides;
  if (!options.sampling.empty()) {
    const std::size_t cross = options.sampling.find('x');
    if (cross == std::string::npos || cross == 0 || cross + 1 == options.sampling.size())
      return Diagnostic{{"--sampling"},
                        fmt::format("\"{}\" is not columns x rows, e.g. 4x15", options.sampling)};
    overrides.push_back({"sampling.columns", options.sampling.substr(0, cross), "--sampling"});
    overrides.push_back({"sampling.rows", options.sampling.substr(cross + 1), "--sampling"});
  }
  if (!options.minParticles.empty())
    overrides.push_back({"sampling.min_particles", options.minParticles, "--min-particles"});
  if (!options.tracer.empty()) overrides.push_back({"tracer.rule", tomlString(options.tracer), "--tracer"});
  return readScene(writeScene(recorded), recorded.name, overrides);
}

ExitCode replay(const ReplayOptions& options, const Console& console) {
  auto reader = TrajectoryReader::open(options.run);
  if (!reader) return console.fail(reader.problems);
  for (const RunEvent& event : reader->events())
    console.say(fmt::format("at {:g} s: {} {}", event.time, event.kind, event.detail));
  const auto changed = sceneFor(options, reader->scene());
  if (!changed) return console.fail(changed.problems);
  const Scene& scene = *changed;
  std::vector<std::uint8_t> tracer;
  if (!options.tracer.empty()) {
    const auto first = reader->frame(0);
    if (!first) return console.fail(first.problems);
    tracer = tagTracer(scene.tracer.rule, (*first)->position, scene.bed.width);
  }
  const auto selected = selectFrames(reader->times(), options.frames);
  if (!selected) return console.fail(selected.problems);

  std::vector<std::unique_ptr<Analysis>> analyses;
  if (!options.analyses.empty()) {
    auto kinds = chooseAnalyses(options.analyses, scene);
    if (!kinds) {
      for (Diagnostic& d : kinds.problems) d.at.file = "--analysis";
      return console.fail(kinds.problems);
    }
    const double span = reader->times()[selected->back()] - reader->times()[selected->front()];
    const AnalysisInput input{scene, selected->size(),
                              span / std::max(1.0, static_cast<double>(selected->size() - 1))};
    for (const AnalysisKind* kind : *kinds) analyses.push_back(kind->make(input));
  }

  const auto folder = makeReplayFolder(options.folder.empty() ? runFolderOf(options.run) / "replay"
                                                              : fs::path(options.folder));
  if (!folder) return console.fail(folder.problems);
  const auto series = openSeries(*folder, scene);
  if (!series) return console.fail(series.problems);

  for (const std::size_t index : *selected) {
    const auto frame = reader->frame(index);
    if (!frame) return console.fail(frame.problems);
    Frame retagged;
    if (!tracer.empty()) {
      retagged = **frame;
      retagged.species = tracer;
    }
    const Frame& seen = tracer.empty() ? **frame : retagged;
    for (const auto& sink : *series) {
      sink->accept(seen);
      if (sink->failure()) return console.fail(*sink->failure());
    }
    for (const auto& analysis : analyses) analysis->accept(seen);
  }
  nlohmann::ordered_json findings = nlohmann::ordered_json::object();
  for (const auto& analysis : analyses) {
    for (const NamedTable& made : analysis->tables())
      if (const auto problem = writeCsv(folder->path / (made.name + ".csv"), made.table))
        return console.fail(*problem);
    for (const Finding& f : analysis->findings()) {
      nlohmann::ordered_json value;
      if (f.value) value = *f.value;
      findings[f.name] = {{"value", value}, {"unit", f.unit}};
    }
  }

  console.say(fmt::format("{} frames re-derived into {}", selected->size(), folder->path.string()));
  if (options.json) {
    const nlohmann::ordered_json result = {{"folder", folder->path.string()},
                                           {"scene", scene.name},
                                           {"frames", selected->size()},
                                           {"from", reader->times()[selected->front()]},
                                           {"to", reader->times()[selected->back()]},
                                           {"findings", findings}};
    console.print(result.dump(2));
  }
  return ExitCode::done;
}

}  // namespace

void addReplayCommand(CLI::App& program, CommandContext context) {
  CLI::App* command = program.add_subcommand("replay", "Re-derive all indices from a recorded run");
  auto options = std::make_shared<ReplayOptions>();
  command->add_option("run", options->run, "Folder of a run, or its trajectory.h5")
      ->required()
      ->type_name("RUN");
  command->add_option("-o,--output", options->folder, "Folder of the series; RUN/replay by default")
      ->type_name("DIR");
  command->add_option("--sampling", options->sampling, "Sampling cells, in place of the scene's")
      ->type_name("CxR");
  command->add_option("--min-particles", options->minParticles, "Cells with fewer particles are not used")
      ->type_name("N");
  std::vector<std::string_view> rules;
  for (const ModelInfo& rule : modelTable<TracerRule>) rules.push_back(rule.name);
  command
      ->add_option("--tracer", options->tracer,
                   fmt::format("Tag the particles anew: {}", fmt::join(rules, ", ")))
      ->type_name("RULE");
  addFrameSelection(*command, options->frames);
  std::vector<std::string_view> analyses;
  for (const AnalysisKind& kind : analysisKinds()) analyses.push_back(kind.name);
  command
      ->add_option("--analysis", options->analyses,
                   fmt::format("Derive more, each into a table of its own: all, or some of {}",
                               fmt::join(analyses, ", ")))
      ->type_name("NAMES");
  command->add_flag("--json", options->json, "Print what was done as JSON");
  command->footer("Example:\n  bedmix replay out/even -o out/even-8x30 --sampling 8x30 --min-particles 6");
  command->callback([options, context] { context.outcome = replay(*options, context.console); });
}

}  // namespace bedmix
