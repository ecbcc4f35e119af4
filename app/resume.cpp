// SPDX-License-Identifier: MIT
#include "app/resume.h"

#include "engine/core/refinement.h"
#include "engine/core/scene_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace bedmix {

namespace {

/// Every setting that a run depends on.
std::vector<SceneSetting> settingsOf(Scene scene) {
  scene.time.duration = 0.0;
  scene.pictures.reset();
  return sceneSettings(scene);
}

/// How many frames a run of the scene has recorded by a step; its last may come early.
std::size_t framesBy(std::int64_t step, const Scene& scene) {
  const std::int64_t perFrame = stepsPerFrame(scene);
  const bool isEarly = step == totalSteps(scene) && step % perFrame != 0;
  return static_cast<std::size_t>(step / perFrame) + (isEarly ? 2 : 1);
}

/// A checkpoint that is whole.
struct Candidate {
  Scene scene;            // with the steps it was taken with
  double interval = 0.0;  // it was taken at, the first being 0; exact whatever the steps
  std::size_t slot = 0;
};
Candidate candidate(const Scene& asked, const CheckpointMark& mark, std::size_t slot) {
  const Scene scene = refined(asked, mark.refinement);
  return {scene, static_cast<double>(mark.step) / static_cast<double>(stepsPerFrame(scene)), slot};
}
/// Taken later, or with shorter steps.
bool isBetter(const Candidate& a, const Candidate& b) {
  if (a.interval != b.interval) return a.interval > b.interval;
  return a.scene.refinement.particles > b.scene.refinement.particles;
}

}  // namespace

std::size_t framesUntil(const CheckpointMark& mark, const Scene& scene) {
  return framesBy(mark.step, refined(scene, mark.refinement));
}

std::optional<Diagnostic> sceneDifference(const Scene& recorded, const Scene& asked) {
  const auto then = settingsOf(recorded), now = settingsOf(asked);
  const auto [was, is] = std::mismatch(then.begin(), then.end(), now.begin(), now.end());
  if (was == then.end() && is == now.end()) return std::nullopt;
  const auto has = [](const auto& settings, const std::string& path) {
    return std::any_of(settings.begin(), settings.end(), [&](const auto& s) { return s.path == path; });
  };
  std::string what;
  if (was != then.end() && is != now.end() && was->path == is->path)
    what = fmt::format("{} is {}, but {} in the recorded run", is->path, is->value, was->value);
  else if (is == now.end() || (was != then.end() && !has(now, was->path)))
    what = fmt::format("{} is {} in the recorded run, and missing here", was->path, was->value);
  else
    what = fmt::format("{} is {}, but not there in the recorded run", is->path, is->value);
  return Diagnostic{
      {"--resume"},
      what + "; give the scene, --set and --seed of that run, only --until and [pictures] may be others"};
}

Result<ResumePoint> findResumePoint(TrajectoryReader recorded, const Scene& scene, int threads,
                                    const Console& console, std::optional<Refinement> refinement) {
  if (auto difference = sceneDifference(recorded.scene(), scene)) return *difference;
  const std::vector<std::vector<std::byte>> found = recorded.checkpoints();
  std::vector<Candidate> sound;
  for (std::size_t slot = 0; slot < found.size(); ++slot) {
    if (const auto mark = checkpointMark(found[slot]))
      sound.push_back(candidate(scene, *mark, slot));
    else if (!found[slot].empty())
      console.warn("one checkpoint is not whole; the run goes on from the other");
  }
  std::sort(sound.begin(), sound.end(), isBetter);
  for (const Candidate& c : sound) {
    const Scene goesOn = refinement ? refined(scene, *refinement) : c.scene;
    Result<Resumed> start = readCheckpoint(found[c.slot], goesOn, threads);
    if (!start) {
      console.warn(start.problems.front().message);
      continue;
    }
    const std::size_t frames = framesBy(start->simulation.step(), goesOn);
    if (frames <= recorded.times().size())
      return ResumePoint{std::move(recorded), std::move(*start), goesOn, frames, c.slot};
    console.warn("a checkpoint is ahead of the recorded frames");
  }
  return Diagnostic{{"--resume"},
                    "the run has no checkpoint to go on from; start it anew with --force in its place",
                    Trouble::file};
}

}  // namespace bedmix
