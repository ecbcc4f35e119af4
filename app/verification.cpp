// SPDX-License-Identifier: MIT
#include "app/verification.h"

#include "app/run_folder.h"
#include "engine/checkpoint.h"
#include "engine/core/particle_list.h"
#include "engine/core/refinement.h"
#include "engine/core/thread_team.h"
#include "engine/simulation.h"
#include "replay/file_trouble.h"
#include "replay/summary.h"
#include "replay/trajectory_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <span>
#include <utility>
#include <vector>

namespace bedmix {

namespace {

int threadsOf(const Scene& scene) { return threadsFor(mostParticles(scene), availableCores()); }

/// A state that the trajectory holds in double precision.
struct StoredState {
  double time;  // s
  Simulation simulation;
  Scene scene;  // with the steps it was taken with
};

/// All that are whole and of the steps the run ended with, oldest first: once a run was gone on with by
/// shorter steps, what comes after an older checkpoint is not what follows from it.
std::vector<StoredState> storedStates(TrajectoryReader& recorded) {
  std::vector<StoredState> states;
  for (const std::vector<std::byte>& bytes : recorded.checkpoints()) {
    const auto mark = checkpointMark(bytes);
    if (!mark) continue;
    const Scene scene = refined(recorded.scene(), mark->refinement);
    Result<Resumed> resumed = readCheckpoint(bytes, scene, threadsOf(scene));
    if (!resumed) continue;
    const double time = resumed->simulation.time();
    states.push_back({time, std::move(resumed->simulation), scene});
  }
  std::int64_t halvings = 0;
  for (const StoredState& s : states) halvings = std::max(halvings, s.scene.refinement.particles);
  std::erase_if(states, [&](const StoredState& s) { return s.scene.refinement.particles != halvings; });
  std::sort(states.begin(), states.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return states;
}

/// The first of two rows of floats that differ, in bits.
std::optional<std::size_t> firstDifference(std::span<const float> a, std::span<const float> b) {
  const auto [at, other] = std::mismatch(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
  });
  if (at == a.end()) return std::nullopt;
  return static_cast<std::size_t>(at - a.begin());
}

std::span<const float> floats(const std::vector<float>& values) { return values; }
std::span<const float> floats(const std::vector<Vec2f>& values) {
  static_assert(sizeof(Vec2f) == 2 * sizeof(float));
  return {reinterpret_cast<const float*>(values.data()), 2 * values.size()};
}

/// What differs first, if anything does; `places` per particle or cell.
template <class T>
std::optional<std::string> difference(const std::vector<T>& is, const std::vector<T>& was, const char* names,
                                      const char* of) {
  constexpr std::size_t places = sizeof(T) / sizeof(float);
  const auto at = firstDifference(floats(is), floats(was));
  if (!at) return std::nullopt;
  std::string_view name = names;
  if (places == 2)
    name = name.substr(*at % 2 == 0 ? 0 : name.find('/') + 1, *at % 2 == 0 ? name.find('/') : name.npos);
  return fmt::format("{} of {} {} is {}, recorded as {}", name, of, *at / places, floats(is)[*at],
                     floats(was)[*at]);
}

std::optional<std::string> difference(const Frame& is, const Frame& was) {
  if (is.id != was.id) return "there are other particles than were recorded";
  if (auto d = difference(is.position, was.position, "x/y", "particle")) return d;
  if (auto d = difference(is.velocity, was.velocity, "v_x/v_y", "particle")) return d;
  if (auto d = difference(is.angularVelocity, was.angularVelocity, "spin", "particle")) return d;
  if (auto d = difference(is.temperature, was.temperature, "temperature", "particle")) return d;
  if (auto d = difference(is.content, was.content, "content", "particle")) return d;
  if (auto d = difference(is.gas.temperature, was.gas.temperature, "temperature", "gas cell")) return d;
  if (auto d = difference(is.gas.voidage, was.gas.voidage, "voidage", "gas cell")) return d;
  if (auto d = difference(is.gas.pressure, was.gas.pressure, "pressure", "gas cell")) return d;
  return difference(is.gas.velocity, was.gas.velocity, "u_x/u_y", "gas cell");
}

/// The hash of the state at the end of the recorded run, where the summary tells it.
std::optional<std::uint64_t> endHash(const std::filesystem::path& run) {
  const auto summary = readSummary(RunFolder{runFolderOf(run)}.summary());
  if (!summary) return std::nullopt;
  return summary->stateHash;
}

Result<StoredState> startOf(const TrajectoryReader& recorded, std::vector<StoredState>& states,
                            std::optional<double> from) {
  const auto isLate = [&](const StoredState& s) { return from && s.time > *from; };
  const auto late = std::find_if(states.begin(), states.end(), isLate);
  const auto best = from ? late : states.begin() + (states.empty() ? 0 : 1);
  if (best != states.begin()) {
    StoredState start = std::move(*(best - 1));
    states.erase(states.begin(), best);
    return start;
  }
  const std::vector<RunEvent>& events = recorded.events();
  if (std::any_of(events.begin(), events.end(), [](const RunEvent& e) { return e.kind == "retry"; }))
    return Diagnostic{
        {"--verify"},
        "the run was gone on with by shorter steps, so that its beginning leads elsewhere; give "
        "--from the time of a checkpoint after that",
        Trouble::file};
  const Scene& scene = recorded.scene();
  Result<Simulation> made = Simulation::make(scene, threadsOf(scene));
  if (!made) return made.problems;
  return StoredState{0.0, std::move(*made), scene};
}

}  // namespace

Result<Verification> verifyRun(const std::filesystem::path& run, std::optional<double> from) {
  auto recorded = TrajectoryReader::open(run);
  if (!recorded) return recorded.problems;
  const std::vector<double>& times = recorded->times();
  std::vector<StoredState> states = storedStates(*recorded);
  // A checkpoint of the last frame has nothing behind it that could be compared.
  if (!from && !states.empty() && states.front().time >= times.back()) from = times.front();
  Result<StoredState> start = startOf(*recorded, states, from);
  if (!start) return start.problems;
  const auto first = std::find(times.begin(), times.end(), start->time);
  if (first == times.end())
    return fileTrouble(run, fmt::format("holds no frame at {:g} s, where its checkpoint is", start->time));

  const Provenance& provenance = recorded->provenance();
  Verification done{.from = start->time,
                    .to = start->time,
                    .program = fmt::format("{} ({})", provenance.version, provenance.commit)};
  Simulation& simulation = start->simulation;
  const std::int64_t perFrame = stepsPerFrame(start->scene), last = totalSteps(start->scene);
  for (auto k = static_cast<std::size_t>(first - times.begin());; ++k) {
    const auto was = recorded->frame(k);
    if (!was) return was.problems;
    const FramePtr is = simulation.frame();
    const auto differs = [&](std::string what) {
      done.mismatch = Mismatch{(*was)->step, (*was)->time, std::move(what)};
      return done;
    };
    if (auto what = difference(*is, **was)) return differs(*what);
    ++done.frames;
    done.to = (*was)->time;
    for (const StoredState& state : states) {
      if (state.time != done.to) continue;
      if (state.simulation.stateHash() != simulation.stateHash())
        return differs("the double state is another than that of the checkpoint");
      ++done.states;
    }
    if (k + 1 == times.size()) break;
    const std::int64_t step = simulation.step(), chunk = perFrame - step % perFrame;
    if (const auto trouble = simulation.advance(std::min(chunk, last - step))) return differs(*trouble);
  }
  if (const auto hash = endHash(run); hash && simulation.step() == last) {
    if (*hash != simulation.stateHash()) {
      done.mismatch = Mismatch{
          simulation.step(), done.to,
          fmt::format("the state hash is {:016x}, {:016x} in summary.json", simulation.stateHash(), *hash)};
      return done;
    }
    ++done.states;
  }
  return done;
}

}  // namespace bedmix
