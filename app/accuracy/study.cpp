// SPDX-License-Identifier: MIT
#include "app/accuracy/study.h"

#include "app/accuracy/contact_errors.h"
#include "app/accuracy/interval.h"
#include "app/accuracy/scene_steps.h"
#include "app/accuracy/statistics.h"
#include "app/accuracy/timing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

namespace bedmix {

namespace {

constexpr int repetitions = 3;          // of timings, divergences and trajectories, each from another seed
constexpr double stretchWall = 0.3;     // s that a timed stretch of `standard` takes
constexpr std::size_t between = 3;      // settings timed between two runs of `standard`
constexpr double timingShare = 0.2;     // of the budget, for repetitions of timings
constexpr double divergenceTime = 0.5;  // s, the longest twins are followed
constexpr double longestHorizon = 0.1;  // s
// Of the time a trajectory can be predicted for: what a setting misses in a step has then grown tenfold, so
// that most of the distance is of the setting's making.
constexpr double horizonShare = 0.2;

}  // namespace

Study::Study(const Scene& scene, const Design& design, SampleLog& log, const Console& console,
             Options options)
    : scene_(scene),
      design_(design),
      log_(log),
      console_(console),
      options_(std::move(options)),
      begin_(std::chrono::steady_clock::now()),
      starts_(scene),
      runner_(log, console, [this] { return mayBegin(); }) {}

double Study::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

bool Study::has(const SampleKey& key) const {
  return std::any_of(log_.samples().begin(), log_.samples().end(),
                     [&](const Sample& s) { return s.key == key; });
}

std::optional<Diagnostic> Study::run() {
  if (auto problem = makeStarts()) return problem;
  timings();
  contacts();
  divergences();
  trajectories();
  statistics();
  return runner_.failure();
}

std::optional<Diagnostic> Study::makeStarts() {
  console_.say("settling and fluidizing the beds that all settings start from ...");
  {
    std::vector<std::jthread> makers;
    for (int r = 0; r < repetitions; ++r) makers.emplace_back([this, r] { starts_.developed(r); });
  }
  for (int r = 0; r < repetitions; ++r)
    if (const auto& start = starts_.developed(r); !start) return start.problems.front();
  return std::nullopt;
}

// `standard` is timed anew after every few settings, so that what else the machine does weighs on both alike.
void Study::timings() {
  const Scene& standard = design_.find(design_.standard).scene;
  const auto time = [](const Scene& scene, const Particles& start, double stretch) {
    Sample sample;
    measureTime(scene, start, stretch, sample);
    return sample.values.at(measure::wall.name);
  };
  const double interval = scene_.sampling.interval;
  const double perSecond = time(standard, *starts_.developed(0), interval) / interval;
  const double most = std::max(1.0, std::floor(starts_.developedAfter() / interval));
  const double stretch = interval * std::clamp(std::round(stretchWall / perSecond / interval), 1.0, most);
  for (int r = 0; r < repetitions; ++r) {
    const double before = elapsed();
    const Particles& start = *starts_.developed(r);
    std::size_t since = 0;
    double last = 0.0;
    std::vector<Task> tasks;
    for (const Setting& setting : design_.settings) {
      const SampleKey key{Panel::timing, setting.name, "", r};
      if (has(key)) continue;
      tasks.push_back({key, 1.0, [&, name = setting.name](Sample& sample) {
                         if (since++ % between == 0) last = time(standard, start, stretch);
                         measureTime(design_.find(name).scene, start, stretch, sample);
                         sample.set(measure::standardWall, last);
                         return true;
                       }});
    }
    runner_.run("wall times, round " + std::to_string(r + 1), tasks, 1);
    if (elapsed() + (elapsed() - before) > timingShare * options_.budget) break;
  }
}

void Study::contacts() {
  std::vector<Task> tasks;
  for (const Setting& setting : design_.settings) {
    const Scene& scene = setting.scene;
    const double cost = 1.0 / longestTaken(scene);
    if (const SampleKey key{Panel::contact, setting.name, "", 0}; !has(key))
      tasks.push_back({key, 0.1 * cost, [&scene](Sample& sample) {
                         measureContacts(scene, sample);
                         return true;
                       }});
    if (const SampleKey key{Panel::drift, setting.name, "", 0};
        !has(key) && design_.turnsContacts(setting.name))
      tasks.push_back(
          {key, cost, [this, &scene](Sample& sample) { return measureDrift(scene, options_.stop, sample); }});
  }
  std::stable_sort(tasks.begin(), tasks.end(), [](const Task& a, const Task& b) { return a.cost > b.cost; });
  runner_.run("single contacts", tasks, options_.cores);
}

void Study::divergences() {
  std::vector<Task> tasks;
  for (int r = 0; r < repetitions; ++r)
    if (const SampleKey key{Panel::divergence, design_.standard, "", r}; !has(key))
      tasks.push_back({key, 1.0, [this, r](Sample& sample) {
                         const auto found =
                             measureDivergence(design_.find(design_.standard).scene, *starts_.developed(r),
                                               std::min(divergenceTime, starts_.developedAfter()));
                         if (!found) {
                           sample.failure = found.problems.front().message;
                           return true;
                         }
                         sample.set(measure::growth, found->growth);
                         if (found->growth > 0.0) sample.set(measure::predictable, found->predictable);
                         return true;
                       }});
  runner_.run("twin runs", tasks, options_.cores);
}

double Study::horizon() const {
  std::vector<double> times;
  for (const Sample& s : log_.samples())
    if (const auto time = s.values.find(measure::predictable.name);
        s.key.panel == Panel::divergence && time != s.values.end())
      times.push_back(time->second);
  const double longest = std::min(longestHorizon, starts_.developedAfter()),
               interval = scene_.sampling.interval;
  const double wanted = times.empty() ? longest : std::min(longest, horizonShare * median(times));
  return interval * std::max(1.0, std::floor(wanted / interval * (1.0 + 1e-9)));
}

void Study::trajectories() {
  const double until = horizon();
  LazyMap<std::pair<std::string, int>, Result<FramePtr>> references;
  std::vector<Task> tasks;
  std::set<SampleKey> planned;
  for (int r = 0; r < repetitions; ++r)
    for (const Sweep& sweep : design_.sweeps)
      for (const Sweep::Turn& turn : sweep.turns) {
        const SampleKey key{Panel::trajectory, turn.setting, sweep.reference, r};
        if (turn.setting == sweep.reference || has(key) || !planned.insert(key).second) continue;
        tasks.push_back({key, 1.0, [this, &references, key, until](Sample& sample) {
                           const Particles& start = *starts_.developed(key.index);
                           const auto reference = references.get({key.reference, key.index}, [&] {
                             return frameAt(design_.find(key.reference).scene, start, until);
                           });
                           const auto frame = frameAt(design_.find(key.setting).scene, start, until);
                           sample.set(measure::horizon, until);
                           if (!frame)
                             sample.failure = frame.problems.front().message;
                           else if (!reference)
                             sample.failure = "the reference failed: " + reference.problems.front().message;
                           else
                             sample.set(measure::position,
                                        median(distances(**frame, **reference, scene_.particles.diameter)));
                           return true;
                         }});
      }
  runner_.run("trajectories", tasks, options_.cores);
}

void Study::statistics() {
  std::map<std::string, std::vector<double>> walls;
  for (const Sample& s : log_.samples())
    if (s.key.panel == Panel::timing && s.failure.empty())
      walls[s.key.setting].push_back(s.values.at(measure::wall.name) / s.values.at(measure::simulated.name));
  std::map<std::string, double> costs;
  for (const auto& [setting, values] : walls) costs[setting] = median(values);
  plan_ = planStatistics(design_, costs, scene_.time.duration, scene_.sampling.interval,
                         options_.budget - elapsed(), options_.cores, options_.runs);

  std::vector<Task> tasks;
  for (int seed = 0; seed < std::max(plan_.presetSeeds, plan_.otherSeeds); ++seed) {
    const std::size_t first = tasks.size();
    for (const std::string& name : design_.statistics) {
      const SampleKey key{Panel::statistics, name, "", seed};
      if (seed >= plan_.seeds(design_, name) || has(key)) continue;
      const auto cost = costs.find(name);
      tasks.push_back({key, cost == costs.end() ? 0.0 : cost->second, [this, key](Sample& sample) {
                         const Setting& setting = design_.find(key.setting);
                         const auto& start = starts_.settled(setting, key.index);
                         if (start)
                           return measureStatistics(setting.scene, *start, plan_.duration, options_.stop,
                                                    sample);
                         sample.failure = start.problems.front().message;
                         return true;
                       }});
    }
    // The longest of a round first, so that the last does not go on alone for long.
    std::stable_sort(tasks.begin() + static_cast<std::ptrdiff_t>(first), tasks.end(),
                     [](const Task& a, const Task& b) { return a.cost > b.cost; });
  }
  runner_.run("statistics", tasks, options_.cores);
}

}  // namespace bedmix
