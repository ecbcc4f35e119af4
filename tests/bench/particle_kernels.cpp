// SPDX-License-Identifier: MIT
#include "engine/core/bed_statistics.h"
#include "engine/core/mixing.h"
#include "engine/core/walls.h"
#include "engine/dem/contacts.h"
#include "engine/dem/integrators.h"
#include "engine/dem/particle_solver.h"
#include "engine/simulation.h"
#include "tests/bench/beds.h"

#include <benchmark/benchmark.h>
#include <map>
#include <utility>

namespace bedmix::bench {

namespace {

using MakeBed = Particles (*)(std::int64_t);

/// Beds are made once, as the framework calls each benchmark several times.
const Particles& bedOf(MakeBed make, std::int64_t particles) {
  static std::map<std::pair<MakeBed, std::int64_t>, Particles> made;
  const std::pair key{make, particles};
  if (!made.contains(key)) made.emplace(key, make(particles));
  return made.at(key);
}

void countParticles(benchmark::State& state) {
  const auto items = static_cast<double>(state.range(0)) * static_cast<double>(state.iterations());
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["s/particle"] =
      benchmark::Counter(items, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void buildNeighbours(benchmark::State& state, MakeBed make) {
  const Particles& bed = bedOf(make, state.range(0));
  const Scene scene = bedScene(state.range(0));
  NeighbourList list(scene.particles.diameter, bedWalls(scene));
  for (auto _ : state) list.build(bed.x, bed.y);
  countParticles(state);
  state.counters["candidates"] = static_cast<double>(list.size()) / static_cast<double>(bed.size());
}

void evaluateContacts(benchmark::State& state, MakeBed make) {
  const Particles& bed = bedOf(make, state.range(0));
  const Scene scene = bedScene(state.range(0));
  NeighbourList list(scene.particles.diameter, bedWalls(scene));
  list.build(bed.x, bed.y);
  ContactHistory from, to;
  from.reset(list.size(), true);
  to.reset(list.size(), true);
  const std::vector<double> zeros(bed.size());
  ContactLoads loads{zeros, zeros, zeros, {}};
  ContactForces<true> forces(scene);
  const Motion at{bed.x.data(), bed.y.data(), bed.vx.data(), bed.vy.data(), bed.spin.data()};
  for (auto _ : state) {
    forces.evaluate(at, list, from, 0.5 * scene.time.step, to, loads);
    std::swap(from, to);
    to.clear();
  }
  countParticles(state);
  state.counters["contacts"] = static_cast<double>(from.count) / static_cast<double>(bed.size());
}

/// The whole step; `integrate` is what is left without neighbours and contacts.
void verletStep(benchmark::State& state, MakeBed make) {
  const Scene scene = bedScene(state.range(0));
  const auto solver = ParticleSolver::make(scene, bedOf(make, state.range(0)), bedWalls(scene));
  for (auto _ : state)
    if (solver->advance(1)) return state.SkipWithError("the bed became invalid");
  countParticles(state);
  state.counters["integrate"] = benchmark::Counter(
      solver->seconds().integrate / static_cast<double>(state.range(0)), benchmark::Counter::kAvgIterations);
}

void sampleMixing(benchmark::State& state) {
  const Particles& bed = bedOf(packedBed, state.range(0));
  Scene scene = bedScene(state.range(0));
  Frame frame;
  for (std::size_t i = 0; i < bed.size(); ++i) frame.position.push_back(toFloat({bed.x[i], bed.y[i]}));
  frame.species = tagTracer(scene.tracer.rule, frame.position, scene.bed.width);
  scene.sampling.columns *= state.range(0) / 1000;
  const SamplingGrid grid = samplingGrid(scene);
  for (auto _ : state) benchmark::DoNotOptimize(mixingSample(frame, grid));
  countParticles(state);
}

void makeFrame(benchmark::State& state) {
  Scene scene = gasScene(state.range(0));
  scene.start.arrangement = Arrangement::drop;
  const Result<Simulation> simulation = Simulation::make(scene);
  if (!simulation) return state.SkipWithError("the bed does not fit");
  for (auto _ : state) benchmark::DoNotOptimize(simulation->frame());
  countParticles(state);
}

constexpr std::int64_t small = 1000, large = 100000;

BENCHMARK_CAPTURE(buildNeighbours, packed, packedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK_CAPTURE(buildNeighbours, agitated, agitatedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK_CAPTURE(evaluateContacts, packed, packedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK_CAPTURE(evaluateContacts, agitated, agitatedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK_CAPTURE(verletStep, packed, packedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK_CAPTURE(verletStep, agitated, agitatedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK(sampleMixing)->Arg(small)->Arg(large);
BENCHMARK(makeFrame)->Arg(small)->Arg(large);

}  // namespace

}  // namespace bedmix::bench
