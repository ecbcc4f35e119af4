// SPDX-License-Identifier: MIT
#include "engine/core/bed_statistics.h"
#include "engine/core/index_band.h"
#include "engine/core/mixing_indices.h"
#include "engine/core/neighbour_index.h"
#include "engine/core/walls.h"
#include "engine/dem/contact_forces.h"
#include "engine/dem/particle_solver.h"
#include "engine/simulation.h"
#include "tests/bench/beds.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cstddef>
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

/// As the integrators choose it.
double innerSkin(const BedState& bed) {
  double fastest = 0.0;  // m/s
  for (const Vec2 v : bed.particles.velocity) fastest = std::max(fastest, norm(v));
  return bed.contacts.innerSkin(bed.step * fastest);
}

/// Sorts the particles, which are in order from the second time on, and finds candidates.
bool makeList(BedState& bed, ContactSlots& spare) {
  if (!bed.sort()) return false;
  const double skin = innerSkin(bed);
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b) bed.contacts.find(b, skin, bed.bodies, spare);
  bed.contacts.link();
  return true;
}

template <class Count>
double perParticle(const BedState& bed, Count&& count) {
  std::size_t all = 0;
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b) all += count(bed.contacts.block(b));
  return static_cast<double>(all) / static_cast<double>(bed.particles.size());
}

void buildList(benchmark::State& state, MakeBed make) {
  const Scene scene = bedScene(state.range(0));
  BedState bed(scene, bedOf(make, state.range(0)), bedWalls(scene), oneThread());
  ContactSlots spare;
  for (auto _ : state)
    if (!makeList(bed, spare)) return state.SkipWithError("not finite");
  countParticles(state);
  state.counters["candidates"] = perParticle(bed, [](const ContactBlock& b) { return b.candidateCount; });
}

/// Which of the candidates a step looks at.
void refreshList(benchmark::State& state, MakeBed make) {
  const Scene scene = bedScene(state.range(0));
  BedState bed(scene, bedOf(make, state.range(0)), bedWalls(scene), oneThread());
  ContactSlots spare;
  if (!makeList(bed, spare)) return state.SkipWithError("not finite");
  const double skin = innerSkin(bed);
  for (auto _ : state)
    for (std::size_t b = 0; b < bed.contacts.blocks(); ++b) bed.contacts.refresh(b, skin, bed.bodies, spare);
  countParticles(state);
  state.counters["near"] = perParticle(bed, [](const ContactBlock& b) { return b.near.count; });
}

void evaluateContacts(benchmark::State& state, MakeBed make) {
  const Scene scene = bedScene(state.range(0));
  BedState bed(scene, bedOf(make, state.range(0)), bedWalls(scene), oneThread());
  ContactSlots spare;
  if (!makeList(bed, spare)) return state.SkipWithError("not finite");
  ContactForces forces(scene);
  forces.setStep(scene.time.step);
  const Motion at{bed.bodies.data(), bed.spinAhead.data()};
  for (auto _ : state)
    for (std::size_t b = 0; b < bed.contacts.blocks(); ++b)
      forces.evaluate(bed, b, at, [](ContactSlots& slots, std::size_t) { return inPlace(slots); });
  countParticles(state);
  state.counters["contacts"] = perParticle(bed, [](const ContactBlock& b) { return b.touching; });
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

/// A packed bed as a frame holds it, its left half tagged, and the paper's 60 cells a thousand particles.
struct SampledBed {
  explicit SampledBed(std::int64_t particles) {
    Scene scene = bedScene(particles);
    for (const Vec2 at : bedOf(packedBed, particles).position) {
      frame.id.push_back(static_cast<std::int32_t>(frame.id.size()));
      frame.position.push_back(toFloat(at));
    }
    frame.species = tagTracer(scene.tracer.rule, frame.position, frame.kind, scene.bed.width);
    scene.sampling.columns *= particles / 1000;
    grid = samplingGrid(scene);
  }
  Frame frame;
  SamplingGrid grid;
};

void sampleMixing(benchmark::State& state) {
  const SampledBed bed(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(mixingSample(bed.frame, bed.grid));
  countParticles(state);
}

void sampleNeighbours(benchmark::State& state) {
  const SampledBed bed(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(neighbourIndex(bed.frame));
  countParticles(state);
}

void sampleAllIndices(benchmark::State& state) {
  const SampledBed bed(state.range(0));
  const StartCorrelation start(bed.frame);
  for (auto _ : state) {
    const CellStatistics cells = cellStatistics(countCells(bed.frame, bed.grid), bed.grid.minParticles);
    for (const MixingIndex& index : mixingIndices())
      benchmark::DoNotOptimize(index.of({bed.frame, cells, start}));
  }
  countParticles(state);
}

void sampleBand(benchmark::State& state) {
  const SampledBed bed(state.range(0));
  const CellCounts counts = countCells(bed.frame, bed.grid);
  for (auto _ : state) benchmark::DoNotOptimize(mixingBand(counts, bed.grid.minParticles, 1));
}

void makeFrame(benchmark::State& state) {
  Scene scene = gasScene(state.range(0));
  scene.start.arrangement = Arrangement::drop;
  const Result<Simulation> simulation = Simulation::make(scene);
  if (!simulation) return state.SkipWithError("the bed does not fit");
  for (auto _ : state) benchmark::DoNotOptimize(simulation->frame());
  countParticles(state);
}

constexpr std::int64_t small = 1000, large = 100000, huge = 1000000;

BENCHMARK_CAPTURE(buildList, packed, packedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK_CAPTURE(buildList, agitated, agitatedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK_CAPTURE(refreshList, packed, packedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK_CAPTURE(refreshList, agitated, agitatedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK_CAPTURE(evaluateContacts, packed, packedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK_CAPTURE(evaluateContacts, agitated, agitatedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK_CAPTURE(verletStep, packed, packedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK_CAPTURE(verletStep, agitated, agitatedBed)->RangeMultiplier(10)->Range(small, large);
BENCHMARK(sampleMixing)->Arg(small)->Arg(large)->Arg(huge);
BENCHMARK(sampleNeighbours)->Arg(small)->Arg(large)->Arg(huge);
BENCHMARK(sampleAllIndices)->Arg(small)->Arg(large);
BENCHMARK(sampleBand)->Arg(small);
BENCHMARK(makeFrame)->Arg(small)->Arg(large);

}  // namespace

}  // namespace bedmix::bench
