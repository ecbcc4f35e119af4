// SPDX-License-Identifier: MIT
#include "engine/core/scene_reader.h"
#include "engine/core/simd.h"
#include "engine/simulation.h"
#include "tests/bench/beds.h"
#include "tests/bench/memory.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>

// Runs whole beds and prints what a step costs, as CSV. State files are particles alone unless --gas asks for
// gas, scenes are run as they are; --set changes either.

namespace bedmix::bench {

namespace {

struct Options {
  std::vector<std::string> inputs;
  std::vector<Override> overrides;
  std::int64_t relax = 500, steps = 1000, tiles = 1;  // of states
  std::int64_t gasColumns = 0;                        // a thousand particles, likewise
  double seconds = 1.0;                               // of scenes
  int threads = 1, repeats = 3;
};

/// One run of one input.
struct Run {
  std::size_t particles = 0;
  std::int64_t steps = 0;
  double timeStep = 0.0;  // s
  double wallSeconds = 0.0;
  StageSeconds stages{};
  std::int64_t contacts = 0;  // at the end
  double bytes = 0.0;         // of all that the simulation holds, at the most
  std::uint64_t stateHash = 0;
};

bool isScene(const std::string& input) { return input.ends_with(".toml"); }

Result<Scene> sceneOf(const std::string& path, const std::vector<Override>& overrides) {
  std::ifstream file(path);
  if (!file) return Diagnostic({path}, "cannot be read", Trouble::file);
  std::ostringstream text;
  text << file.rdbuf();
  return readScene(text.str(), path, overrides);
}

/// Takes `relax` steps, then those that are measured. `before` is the memory before there was a bed.
Result<Run> measure(Simulation& simulation, const Scene& scene, std::int64_t relax, std::int64_t steps,
                    double before) {
  if (auto trouble = simulation.advance(relax)) return Diagnostic({scene.name}, *trouble);
  Run run;
  run.steps = steps;
  run.timeStep = scene.time.step;
  run.particles = static_cast<std::size_t>(scene.particles.count);
  const StageSeconds stages = simulation.stageSeconds();
  const auto start = std::chrono::steady_clock::now();
  if (auto trouble = simulation.advance(steps)) return Diagnostic({scene.name}, *trouble);
  run.wallSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (std::size_t s = 0; s < stages.size(); ++s) run.stages[s] = simulation.stageSeconds()[s] - stages[s];
  run.contacts = simulation.contacts();
  run.bytes = peakMemory() - before;
  run.stateHash = simulation.stateHash();
  return run;
}

Result<Run> runState(const std::string& path, const Options& options) {
  const double before = memoryNow();
  Result<Particles> start = readBed(path, options.tiles);
  if (!start) return start.problems;
  const auto particles = static_cast<std::int64_t>(start->size());
  const Scene plain = options.gasColumns > 0 ? gasScene(particles, options.gasColumns) : bedScene(particles);
  const Result<Scene> scene = readScene(writeScene(plain), path, options.overrides);
  if (!scene) return scene.problems;
  Particles bed = makeParticles(*scene, start->position);
  bed.velocity = std::move(start->velocity);
  start->position = {};
  forgetPeakMemory();  // reading takes more than the bed
  Simulation simulation = Simulation::make(*scene, std::move(bed), options.threads);
  return measure(simulation, *scene, options.relax, options.steps, before);
}

Result<Run> runScene(const std::string& path, const Options& options) {
  const Result<Scene> scene = sceneOf(path, options.overrides);
  if (!scene) return scene.problems;
  const double before = memoryNow();
  forgetPeakMemory();
  Result<Simulation> simulation = Simulation::make(*scene, options.threads);
  if (!simulation) return simulation.problems;
  return measure(*simulation, *scene, 0, std::llround(options.seconds / scene->time.step), before);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

constexpr const char* columns =
    "case,particles,threads,simd,steps,repeats,seconds_per_simulated_second,ns_per_particle_step";

/// One row: medians over the repeats, ns per particle and step.
std::string row(const std::string& input, const Options& options, const std::vector<Run>& runs) {
  const Run& one = runs.front();
  const auto particles = static_cast<double>(one.particles), steps = static_cast<double>(one.steps);
  const auto medianOf = [&](auto value) {
    std::vector<double> values;
    for (const Run& run : runs) values.push_back(value(run));
    return median(std::move(values));
  };
  std::string name = std::filesystem::path(input).stem().string();
  if (!isScene(input))
    name += (options.tiles > 1 ? fmt::format("x{}", options.tiles) : "") +
            (options.gasColumns > 0 ? fmt::format("-gas{}", options.gasColumns) : "");
  const double wall = medianOf([](const Run& run) { return run.wallSeconds; });
  std::string text =
      fmt::format("{},{},{},{},{},{},{:.3f},{:.2f}", name, one.particles, options.threads,
                  simdLevelNames()[static_cast<std::size_t>(simdLevel())], one.steps, runs.size(),
                  wall / (steps * one.timeStep), 1e9 * wall / (particles * steps));
  for (std::size_t s = 0; s < stageNames.size(); ++s)
    text += fmt::format(",{:.2f}",
                        medianOf([&](const Run& run) { return 1e9 * run.stages[s] / (particles * steps); }));
  return text + fmt::format(",{:.2f},{:.0f},{:016x}", static_cast<double>(one.contacts) / particles,
                            medianOf([&](const Run& run) { return run.bytes / particles; }), one.stateHash);
}

Result<std::string> measureAll(const std::string& input, const Options& options) {
  std::vector<Run> runs;
  for (int r = 0; r < options.repeats; ++r) {
    const Result<Run> run = isScene(input) ? runScene(input, options) : runState(input, options);
    if (!run) return run.problems;
    if (r > 0 && run->stateHash != runs.front().stateHash)
      return Diagnostic({input}, "two runs end in different states: results are not reproducible");
    runs.push_back(*run);
  }
  return row(input, options, runs);
}

int complain(const std::string& what) {
  std::cerr << "bench_run: " << what << '\n';
  return 1;
}

}  // namespace

}  // namespace bedmix::bench

int main(int argc, char** argv) {
  using namespace bedmix;
  bench::Options options;
  std::string simd;
  std::vector<std::string> changes;
  CLI::App app{"What a step of whole beds costs, as CSV: medians over repeats, ns per particle and step."};
  app.add_option("input", options.inputs, "state files (rows x y vx vy) and scenes (.toml)")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--relax", options.relax, "steps of a state before the clock starts")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--steps", options.steps, "measured steps of a state")->check(CLI::PositiveNumber);
  app.add_option("--tile", options.tiles, "a state so many times side by side")->check(CLI::PositiveNumber);
  app.add_option("--gas", options.gasColumns,
                 "a state with gas at 2 u_mf, so many columns of 27 cells a thousand particles")
      ->check(CLI::PositiveNumber);
  app.add_option("--seconds", options.seconds, "measured time of a scene")->check(CLI::PositiveNumber);
  app.add_option("--set", changes, "PATH=VALUE of the scene, as for bedmix run")->allow_extra_args(false);
  app.add_option("--threads", options.threads)->check(CLI::PositiveNumber);
  app.add_option("--simd", simd, "baseline, avx2 or avx512; the best there is by default");
  app.add_option("--repeats", options.repeats)->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  for (const std::string& change : changes) {
    const std::size_t equals = change.find('=');
    if (equals == std::string::npos) return bench::complain("--set " + change + ": not PATH=VALUE");
    options.overrides.push_back({change.substr(0, equals), change.substr(equals + 1)});
  }
  if (!simd.empty()) {
    const auto level = simdLevelNamed(simd);
    if (!level || !useSimdLevel(*level)) return bench::complain("--simd " + simd + ": not on this machine");
  }

  std::string header = bench::columns;
  for (const std::string_view stage : stageNames) header += ',' + std::string(stage);
  std::cout << header << ",contacts_per_particle,bytes_per_particle,state_hash" << std::endl;
  for (const std::string& input : options.inputs) {
    const Result<std::string> row = bench::measureAll(input, options);
    if (!row) return bench::complain(toString(row.problems.front()));
    std::cout << *row << std::endl;
  }
}
