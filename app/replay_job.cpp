// SPDX-License-Identifier: MIT
#include "app/replay_job.h"

#include "app/run_folder.h"
#include "app/series.h"
#include "engine/core/scene_keys.h"
#include "engine/core/scene_reader.h"
#include "render/sheet.h"
#include "replay/analysis/line_flux.h"
#include "replay/tracer_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

namespace bedmix {

namespace {

/// The recorded scene with what the settings change in it.
Result<Scene> changedScene(const ReplaySettings& settings, const Scene& recorded) {
  std::vector<Override> overrides;
  if (!settings.sampling.empty()) {
    const std::size_t cross = settings.sampling.find('x');
    if (cross == std::string::npos || cross == 0 || cross + 1 == settings.sampling.size())
      return Diagnostic{{"--sampling"},
                        fmt::format("\"{}\" is not columns x rows, e.g. 4x15", settings.sampling)};
    overrides.push_back({"sampling.columns", settings.sampling.substr(0, cross), "--sampling"});
    overrides.push_back({"sampling.rows", settings.sampling.substr(cross + 1), "--sampling"});
  }
  if (!settings.minParticles.empty())
    overrides.push_back({"sampling.min_particles", settings.minParticles, "--min-particles"});
  return readScene(writeScene(recorded), recorded.name, overrides);
}

Result<std::optional<Retagging>> retagging(RecordedRun& run, const ReplaySettings& settings,
                                           const Scene& scene) {
  if (settings.tracer.empty()) return std::optional<Retagging>{};
  const auto choice = TracerChoice::parse(settings.tracer);
  if (!choice) return choice.problems;
  std::size_t index = 0;
  if (settings.tracerAt) {
    auto at = framesAt(run.reader->times(), std::array{*settings.tracerAt});
    if (!at) {
      for (Diagnostic& d : at.problems) d.at.file = "--tracer-at";
      return at.problems;
    }
    index = at->front();
  }
  const auto frame = run.reader->frame(index);
  if (!frame) return frame.problems;
  auto tags = choice->tag(**frame, scene);
  if (!tags) return tags.problems;
  return std::optional(Retagging(**frame, std::move(*tags)));
}

Result<std::vector<std::unique_ptr<Analysis>>> makeAnalyses(const ReplaySettings& settings,
                                                            const AnalysisInput& input) {
  std::vector<std::unique_ptr<Analysis>> analyses;
  for (const std::vector<double>& ends : settings.lines) {
    const FluxLine line{{ends[0], ends[1]}, {ends[2], ends[3]}};
    if (line.from == line.to) return Diagnostic{{"--line"}, "its ends are the same; give X0,Y0,X1,Y1"};
    analyses.push_back(std::make_unique<LineFlux>(input, line, fmt::format("line_{}", analyses.size() + 1)));
  }
  if (settings.analyses.empty()) return analyses;
  auto kinds = chooseAnalyses(settings.analyses, input.scene);
  if (!kinds) {
    for (Diagnostic& d : kinds.problems) d.at.file = "--analysis";
    return kinds.problems;
  }
  for (const AnalysisKind* kind : *kinds) analyses.push_back(kind->make(input));
  return analyses;
}

}  // namespace

Result<Replayed> replayRun(RecordedRun& run, const ReplaySettings& settings,
                           const std::filesystem::path& into, FrameSink* watching) {
  const auto scene = changedScene(settings, run.scene());
  if (!scene) return scene.problems;
  const auto tracer = retagging(run, settings, *scene);
  if (!tracer) return tracer.problems;
  const std::vector<double>& times = run.reader->times();
  const auto selected = selectFrames(times, settings.frames);
  if (!selected) return selected.problems;

  Replayed done;
  done.frames = selected->size();
  done.from = times[selected->front()];
  done.to = times[selected->back()];
  const double gaps = std::max(1.0, static_cast<double>(done.frames - 1));
  auto analyses = makeAnalyses(settings, {*scene, done.frames, (done.to - done.from) / gaps});
  if (!analyses) return analyses.problems;
  const auto folder = makeReplayFolder(into);
  if (!folder) return folder.problems;
  done.folder = folder->path;
  const auto series = openSeries(*folder, *scene);
  if (!series) return series.problems;

  for (const std::size_t index : *selected) {
    auto frame = run.reader->frame(index);
    if (!frame) return frame.problems;
    if (*tracer) *frame = std::make_shared<const Frame>((**tracer).applied(**frame));
    for (const auto& sink : *series) {
      sink->accept(**frame);
      if (sink->failure()) return *sink->failure();
    }
    for (const auto& analysis : *analyses) analysis->accept(**frame);
    if (watching) watching->accept(**frame);
  }

  done.series = seriesNames(*scene);
  for (const auto& analysis : *analyses) {
    for (const NamedTable& made : analysis->tables()) {
      if (auto problem = writeCsv(done.folder / (made.name + ".csv"), made.table)) return *problem;
      done.series.push_back(made.name);
    }
    const std::vector<FoundNumber> found = analysis->findings();
    done.findings.insert(done.findings.end(), found.begin(), found.end());
  }
  return done;
}

}  // namespace bedmix
