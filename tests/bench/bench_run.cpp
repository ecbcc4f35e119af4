// SPDX-License-Identifier: MIT
#include "engine/core/hash.h"
#include "engine/core/scene_reader.h"
#include "engine/core/walls.h"
#include "engine/dem/particle_solver.h"
#include "engine/simulation.h"
#include "tests/bench/beds.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>

// Runs whole beds and prints what a step costs, as CSV. State files are particles alone, scenes are run as
// they are, with their gas.

namespace bedmix::bench {

namespace {

struct Options {
  std::vector<std::string> inputs;
  std::int64_t relax = 500, steps = 1000;  // of states
  double seconds = 1.0;                    // of scenes
  int threads = 1, repeats = 3;
};

/// One run of one input.
struct Run {
  std::size_t particles = 0;
  std::int64_t steps = 0;
  double wallSeconds = 0.0;
  StageSeconds stages{};
  std::int64_t contacts = 0;  // at the end
  std::uint64_t stateHash = 0;
};

double& stageOf(StageSeconds& seconds, Stage stage) { return seconds[static_cast<std::size_t>(stage)]; }

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

Result<Run> runState(const std::string& path, const Options& options) {
  Result<Particles> start = readBed(path);
  if (!start) return start.problems;
  const Scene scene = bedScene(static_cast<std::int64_t>(start->size()));
  Run run;
  run.particles = start->size();
  run.steps = options.steps;
  const auto solver = ParticleSolver::make(scene, std::move(*start), bedWalls(scene));
  if (solver->advance(options.relax)) return Diagnostic({path}, "became invalid before it was measured");

  const DemSeconds before = solver->seconds();
  const Stopwatch stopwatch;
  const bool invalid = solver->advance(options.steps).has_value();
  run.wallSeconds = stopwatch.seconds();
  if (invalid) return Diagnostic({path}, "became invalid while it was measured");
  const DemSeconds& after = solver->seconds();
  stageOf(run.stages, Stage::neighbours) = after.neighbours - before.neighbours;
  stageOf(run.stages, Stage::contacts) = after.contacts - before.contacts;
  stageOf(run.stages, Stage::integrate) = after.integrate - before.integrate;
  run.contacts = solver->contactCount();
  StateHash hash;
  solver->hashInto(hash);
  run.stateHash = hash.value();
  return run;
}

/// Those that touch in a frame.
std::int64_t contactsIn(const Frame& frame, const Scene& scene) {
  std::vector<Vec2> positions;
  for (const Vec2f p : frame.position) positions.push_back({p.x, p.y});
  const auto solver = ParticleSolver::make(scene, makeParticles(scene, positions), bedWalls(scene));
  return solver->advance(0) ? 0 : solver->contactCount();
}

Result<Run> runScene(const std::string& path, const Options& options) {
  std::ifstream file(path);
  if (!file) return Diagnostic({path}, "cannot be read", Trouble::file);
  std::ostringstream text;
  text << file.rdbuf();
  const Result<Scene> scene = readScene(text.str(), path);
  if (!scene) return scene.problems;
  Result<Simulation> simulation = Simulation::make(*scene, options.threads);
  if (!simulation) return simulation.problems;

  Run run;
  run.steps = std::llround(options.seconds / scene->time.step);
  const Stopwatch stopwatch;
  const std::optional<std::string> trouble = simulation->advance(run.steps);
  run.wallSeconds = stopwatch.seconds();
  if (trouble) return Diagnostic({path}, *trouble);
  run.stages = simulation->stageSeconds();
  const FramePtr frame = simulation->frame();
  run.particles = frame->size();
  run.contacts = contactsIn(*frame, *scene);
  run.stateHash = simulation->stateHash();
  return run;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// One row: medians over the repeats, ns per particle and step.
std::string row(const std::string& input, const Options& options, const std::vector<Run>& runs) {
  const Run& one = runs.front();
  const double particleSteps = static_cast<double>(one.particles) * static_cast<double>(one.steps);
  const auto perParticleStep = [&](auto secondsOf) {
    std::vector<double> values;
    for (const Run& run : runs) values.push_back(1e9 * secondsOf(run) / particleSteps);
    return median(std::move(values));
  };
  std::string text = fmt::format("{},{},{},{},{},{:.2f}", std::filesystem::path(input).stem().string(),
                                 one.particles, options.threads, one.steps, runs.size(),
                                 perParticleStep([](const Run& run) { return run.wallSeconds; }));
  for (std::size_t s = 0; s < stageNames.size(); ++s)
    text += fmt::format(",{:.2f}", perParticleStep([s](const Run& run) { return run.stages[s]; }));
  return text + fmt::format(",{:.2f},{:016x}",
                            static_cast<double>(one.contacts) / static_cast<double>(one.particles),
                            one.stateHash);
}

Result<std::string> measure(const std::string& input, const Options& options) {
  std::vector<Run> runs;
  for (int r = 0; r < options.repeats; ++r) {
    const Result<Run> run = input.ends_with(".toml") ? runScene(input, options) : runState(input, options);
    if (!run) return run.problems;
    if (r > 0 && run->stateHash != runs.front().stateHash)
      return Diagnostic({input}, "two runs end in different states: results are not reproducible");
    runs.push_back(*run);
  }
  return row(input, options, runs);
}

}  // namespace

}  // namespace bedmix::bench

int main(int argc, char** argv) {
  using namespace bedmix;
  bench::Options options;
  CLI::App app{"What a step of whole beds costs, as CSV: medians over repeats, ns per particle and step."};
  app.add_option("input", options.inputs, "state files (rows x y vx vy) and scenes (.toml)")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--relax", options.relax, "steps of a state before the clock starts")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--steps", options.steps, "measured steps of a state")->check(CLI::PositiveNumber);
  app.add_option("--seconds", options.seconds, "measured time of a scene")->check(CLI::PositiveNumber);
  app.add_option("--threads", options.threads, "of scenes")->check(CLI::PositiveNumber);
  app.add_option("--repeats", options.repeats)->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);

  std::string header = "case,particles,threads,steps,repeats,ns_per_particle_step";
  for (const std::string_view stage : stageNames) header += ',' + std::string(stage);
  std::cout << header << ",contacts_per_particle,state_hash" << std::endl;
  for (const std::string& input : options.inputs) {
    const Result<std::string> row = bench::measure(input, options);
    if (!row) {
      for (const Diagnostic& problem : row.problems) std::cerr << "bench_run: " << toString(problem) << '\n';
      return 1;
    }
    std::cout << *row << std::endl;
  }
}
