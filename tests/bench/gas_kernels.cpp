// SPDX-License-Identifier: MIT
#include "engine/core/thread_team.h"
#include "engine/coupling/exchange.h"
#include "engine/coupling/voidage.h"
#include "engine/gas/gas_solver.h"
#include "tests/bench/beds.h"

#include <benchmark/benchmark.h>
#include <optional>

namespace bedmix::bench {

namespace {

/// A gas grid of `columns` x `rows` whose lower half holds a square lattice of spacing 1.1 d, voidage 0.57.
/// One allocation, since its parts point at each other.
struct CoupledBed {
  Scene scene;
  ThreadTeam team;
  GasSolver gas;
  VoidageField voidage;
  Exchange exchange;
  Particles particles;

  explicit CoupledBed(Scene s, int threads = 1)
      : scene(std::move(s)),
        team(threads),
        gas(scene, team),
        voidage(scene, gas.grid(), team),
        exchange(scene, gas, voidage, team),
        particles(lattice(scene)) {
    particles.addExternalForces();
    voidage.update(particles.position);
    gas.startWith(voidage.voidage());
  }
  CoupledBed(const CoupledBed&) = delete;
  CoupledBed& operator=(const CoupledBed&) = delete;

  static Particles lattice(const Scene& scene) {
    const double spacing = 1.1 * scene.particles.diameter;
    std::vector<Vec2> centres;
    for (double y = spacing / 2; y < scene.bed.height / 2; y += spacing)
      for (double x = spacing / 2; x < scene.bed.width; x += spacing) centres.push_back({x, y});
    return makeParticles(scene, centres);
  }
};

/// The paper's rows for its 27 of two heights; else cells of 12 mm.
Scene sceneOf(std::int64_t columns, std::int64_t rows) {
  Scene scene = gasScene(columns * 1000 / 8);
  if (rows == 27) return scene;
  scene.gas->grid.rows = {{rows, 0.012}};
  scene.bed.height = 0.012 * static_cast<double>(rows);
  return scene;
}

void countItems(benchmark::State& state, std::size_t itemsOfOne, const char* name) {
  const auto items = static_cast<double>(itemsOfOne) * static_cast<double>(state.iterations());
  state.SetItemsProcessed(static_cast<std::int64_t>(items));
  state.counters[name] = benchmark::Counter(items, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void updateVoidage(benchmark::State& state) {
  CoupledBed bed(sceneOf(state.range(0), state.range(1)));
  for (auto _ : state) bed.voidage.update(bed.particles.position);
  countItems(state, bed.particles.size(), "s/particle");
}

void evaluateDrag(benchmark::State& state) {
  CoupledBed bed(sceneOf(state.range(0), state.range(1)));
  for (auto _ : state) {
    bed.exchange.evaluateDrag(bed.particles, bed.gas.exchange());
    bed.exchange.applyForces(bed.particles);
  }
  countItems(state, bed.particles.size(), "s/particle");
}

/// The bed shakes by what a particle of 0.5 m/s moves in a gas step, so that each step has work to do.
void stepGas(benchmark::State& state) {
  CoupledBed bed(sceneOf(state.range(0), state.range(1)), static_cast<int>(state.range(2)));
  std::vector<Vec2> raised = bed.particles.position;
  for (Vec2& p : raised) p.y += 0.5 * bed.scene.gas->step;
  const std::vector<double> down = bed.voidage.voidage();
  bed.voidage.update(raised);
  const std::vector<double> up = bed.voidage.voidage();
  bed.exchange.evaluateDrag(bed.particles, bed.gas.exchange());
  bool high = false;
  for (auto _ : state)
    if (!bed.gas.advance((high = !high) ? up : down).solved) return state.SkipWithError("not finite");
  countItems(state, bed.gas.grid().cells(), "s/cell");
}

void gasGrids(benchmark::internal::Benchmark* b) {
  b->Args({8, 27})->Args({64, 128})->Args({256, 512})->Unit(benchmark::kMicrosecond);
}

BENCHMARK(updateVoidage)->Apply(gasGrids);
BENCHMARK(evaluateDrag)->Apply(gasGrids);

/// By threads; the particles' 100,000 have 800 x 27 cells.
BENCHMARK(stepGas)
    ->ArgNames({"columns", "rows", "threads"})
    ->Args({8, 27, 1})
    ->ArgsProduct({{800}, {27}, {1, 2, 4}})
    ->ArgsProduct({{64}, {128}, {1, 4}})
    ->ArgsProduct({{256}, {512}, {1, 4}})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace bedmix::bench
