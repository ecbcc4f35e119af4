// SPDX-License-Identifier: MIT
#include "app/attempts.h"

#include "app/interrupt.h"
#include "app/progress.h"
#include "app/version.h"
#include "engine/core/refinement.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <utility>

namespace bedmix {

std::string settingsText(const RefinedSettings& settings) {
  std::string text;
  for (const auto& [path, value] : settings)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", path, value);
  return text;
}

namespace {

RunEvent resumeEvent(double time) {
  return {time, "resume",
          fmt::format("by bedmix {} ({}) at {:%Y-%m-%dT%H:%M:%SZ}", programVersion, programCommit,
                      fmt::gmtime(std::time(nullptr)))};
}

RunEvent retryEvent(const Retry& retry) {
  return {retry.time, "retry",
          fmt::format("from {:g} s with {}: {}", retry.from, settingsText(retry.settings), retry.reason)};
}

/// Computes until the solver ends, a stop is asked for or a file cannot be written.
RunEnd follow(Worker& worker, Recording& recording, Progress progress) {
  while (const FramePtr frame = worker.next()) {
    recording.accept(*frame);
    if (const Checkpoint checkpoint = worker.checkpoint()) recording.keep(*checkpoint);
    progress.accept(*frame);
    if (checkpointRequested()) worker.requestCheckpoint();
    if (stopRequested() || recording.failure()) worker.requestStop();
  }
  return worker.end();
}

/// The scene of another attempt, where one may help.
std::optional<Scene> sceneOfRetry(const RunPlan& plan, const RunOutcome& outcome) {
  if (!plan.retries || !outcome.end.cure || outcome.failure) return std::nullopt;
  Scene scene = refined(outcome.scene, *outcome.end.cure);
  if (scene.refinement.particles > mostHalvings) return std::nullopt;
  return scene;
}

/// The last checkpoint of the run in its folder, to be gone on with in the refined scene.
Result<ResumePoint> goBack(const RunPlan& plan, const Scene& refined, const Console& console) {
  auto recorded = TrajectoryReader::open(plan.folder.path);
  if (!recorded) return recorded.problems;
  return findResumePoint(std::move(*recorded), plan.scene, plan.threads, console, refined.refinement);
}

}  // namespace

Result<RunOutcome> carryOut(const RunPlan& plan, std::optional<ResumePoint> from, const Console& console) {
  RunOutcome outcome;
  outcome.scene = from ? from->scene : plan.scene;
  std::vector<RunEvent> news;  // that are not in the trajectory yet
  if (from) news.push_back(resumeEvent(from->start.simulation.time()));
  for (;;) {
    auto recording = from ? Recording::resume(plan.folder, plan.scene, plan.film, *from)
                          : Recording::create(plan.folder, plan.scene, plan.film);
    if (!recording) return recording.problems;
    for (const RunEvent& event : news) recording->note(event);
    // From now on, whatever ends the program, the run goes on with these steps.
    if (from && !outcome.retries.empty())
      recording->keep(writeCheckpoint(from->start.simulation, outcome.scene, from->start.wallSeconds));

    const bool hasCheckpoint = from.has_value();
    Worker worker = from ? Worker(outcome.scene, std::move(from->start), plan.schedule)
                         : Worker(outcome.scene, plan.threads, plan.schedule);
    outcome.end = follow(worker, *recording, Progress(console, plan.scene.time.duration));
    outcome.failure = recording->failure();
    const std::optional<Scene> next = sceneOfRetry(plan, outcome);
    if (!next) {
      recording->finish();
      outcome.failure = recording->failure();
      outcome.filmProblems = recording->filmProblems();
      return outcome;
    }

    outcome.scene = *next;
    recording.value.reset();  // before the file is read
    from.reset();
    if (hasCheckpoint || outcome.end.lastCheckpoint) {
      auto point = goBack(plan, *next, console);
      if (!point) return point.problems;
      from.emplace(std::move(*point));
      news.clear();
    }
    outcome.retries.push_back({outcome.end.simulatedSeconds, from ? from->start.simulation.time() : 0.0,
                               outcome.end.message, refinedSettings(*next)});
    news.push_back(retryEvent(outcome.retries.back()));
    console.warn("retry " + news.back().detail);
  }
}

}  // namespace bedmix
