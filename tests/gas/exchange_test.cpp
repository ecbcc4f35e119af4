// SPDX-License-Identifier: MIT
#include "engine/coupling/exchange.h"

#include "engine/core/rng.h"
#include "engine/core/simd.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bedmix {
namespace {

/// Particles at random places and velocities in gas that has run a few steps.
struct CoupledBed {
  Scene scene;
  ThreadTeam team;
  GasSolver gas;
  VoidageField voidage;
  Exchange exchange;
  Particles particles;

  CoupledBed(const Scene& s, std::size_t count, int threads = 1)
      : scene(s), team(threads), gas(s, team), voidage(s, gas.grid(), team), exchange(s, gas, voidage, team) {
    Rng rng(5);
    std::vector<Vec2> at;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = rng.uniform(0.0015, scene.bed.width - 0.0015);
      at.push_back({x, rng.uniform(floorHeight(scene, x) + 0.001, scene.bed.height + 0.01)});
    }
    std::sort(at.begin(), at.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
    particles = makeParticles(scene, at);
    for (Vec2& v : particles.velocity) v = {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    particles.addExternalForces();
    voidage.update(particles.position);
    gas.startWith(voidage.voidage());
  }

  void gasStep() {
    voidage.update(particles.position);
    exchange.evaluateDrag(particles, gas.exchange());
    ASSERT_TRUE(gas.advance(voidage.voidage()).solved);
    exchange.applyForces(particles);
  }
  /// Flight without contacts under drag and external forces.
  void particleSteps(int steps, double span) {
    const double h = span / steps, perMass = 1.0 / particles.mass;
    for (int step = 0; step < steps; ++step)
      for (std::size_t i = 0; i < particles.size(); ++i) {
        const double slower = 1.0 / (1.0 + h * particles.drag[i] * perMass);
        particles.velocity[i] = slower * (particles.velocity[i] + h * perMass * particles.external[i]);
        particles.position[i] += h * particles.velocity[i];
      }
  }
};

/// The incline over cells of three sizes along each axis.
Scene unevenScene() {
  Scene scene = test::inclinedScene();
  scene.bed.width = 0.384;
  scene.gas->grid.columns = {{8, 0.008}, {16, 0.012}, {8, 0.016}};
  scene.gas->grid.rows = {{10, 0.012}, {10, 0.018}, {12, 0.01}};
  return scene;
}

/// The two of `at` around a place and the weight of the upper one; the outermost beyond them.
struct Neighbours {
  int lower, upper;
  double share;
};
Neighbours around(const std::vector<double>& at, double place) {
  const auto next = std::upper_bound(at.begin(), at.end(), place);
  if (next == at.begin()) return {0, 0, 0.0};
  const int lower = static_cast<int>(next - at.begin()) - 1;
  if (next == at.end()) return {lower, lower, 0.0};
  return {lower, lower + 1, (place - at[lower]) / (*next - at[lower])};
}

TEST(Exchange, GivesDragToTheFacesByBilinearWeights) {
  CoupledBed bed(unevenScene(), 2500);
  for (int step = 0; step < 3; ++step) bed.gasStep();
  const GasGrid& grid = bed.gas.grid();
  std::vector<double> columns, rows;  // centres
  for (int i = 0; i < grid.columns; ++i) columns.push_back(0.5 * (grid.x[i] + grid.x[i + 1]));
  for (int j = 0; j < grid.rows; ++j) rows.push_back(0.5 * (grid.y[j] + grid.y[j + 1]));
  // Below the distributor the lowest open face of the column stands in.
  const auto upright = [&](int i, int j) {
    const int right = std::min(i, grid.columns - 1), left = std::max(i - 1, 0);
    return bed.gas.layout().uFace(i, std::max(j, std::min(grid.lowestRow[left], grid.lowestRow[right])));
  };
  const auto level = [&](int i, int j) { return bed.gas.layout().vFace(i, std::max(j, grid.lowestRow[i])); };
  std::vector<double> expected(bed.gas.exchange().coefficient.size());
  double largest = 0.0;
  for (std::size_t p = 0; p < bed.particles.size(); ++p) {
    const Vec2 at = bed.particles.position[p];
    const double drag = bed.particles.drag[p];
    const auto give = [&](Neighbours x, Neighbours y, const auto& face) {
      expected[face(x.lower, y.lower)] += drag * (1.0 - x.share) * (1.0 - y.share);
      expected[face(x.upper, y.lower)] += drag * x.share * (1.0 - y.share);
      expected[face(x.lower, y.upper)] += drag * (1.0 - x.share) * y.share;
      expected[face(x.upper, y.upper)] += drag * x.share * y.share;
    };
    give(around(grid.x, at.x), around(rows, at.y), upright);
    give(around(columns, at.x), around(grid.y, at.y), level);
    largest = std::max(largest, drag);
  }
  ASSERT_GT(largest, 0.0);
  for (std::size_t f = 0; f < expected.size(); ++f)
    EXPECT_NEAR(bed.gas.exchange().coefficient[f], expected[f], 1e-12 * largest);
}

/// Gas steps of these lengths, s, in turn.
void expectMomentumConserved(const std::vector<double>& lengths,
                             const std::vector<ObstacleSettings>& obstacles = {}) {
  Scene scene = test::inclinedScene();
  scene.obstacles = obstacles;
  scene.particles.density = 1.0;
  scene.gas->step = lengths.front();
  scene.gravity = 0.0;
  CoupledBed bed(scene, 700);
  const GasFields& gas = bed.gas.fields();
  const MomentumExchange& drag = bed.gas.exchange();
  const int firstLevel = bed.gas.layout().vFace(0, 0), faces = bed.gas.layout().faces();
  Particles& p = bed.particles;
  Vec2 taken, given;  // N s, from the gas and by the particles
  double size = 0.0, strongest = 0.0;
  for (std::size_t step = 0; step < 12; ++step) {
    const double length = lengths[step % lengths.size()];
    bed.gas.setStep(length);
    bed.exchange.setStep(length);
    bed.gasStep();
    for (int f = 0; f < faces; ++f) {
      const double impulse = length * (drag.coefficient[f] * gas.velocity[f] - drag.source[f]);
      (f < firstLevel ? taken.x : taken.y) += impulse;
      size += std::abs(impulse);
    }
    Particles dragless = p;
    std::fill(dragless.drag.begin(), dragless.drag.end(), 0.0);
    bed.exchange.applyForces(dragless);  // the pressure's part
    const Particles start = p;
    bed.particleSteps(10, length);
    Vec2 owed;
    for (std::size_t i = 0; i < p.size(); ++i) {
      given +=
          length * (p.external[i] - dragless.external[i]) - p.drag[i] * (p.position[i] - start.position[i]);
      owed += p.drag[i] * (p.position[i] - p.foreseen[i]);
      strongest = std::max(strongest, p.drag[i] * length / p.mass);
    }
    EXPECT_NEAR(taken.x, given.x + owed.x, 1e-12 * size) << step;
    EXPECT_NEAR(taken.y, given.y + owed.y, 1e-12 * size) << step;
    // Nothing else is remembered of the particles: their order may change.
    std::reverse(p.position.begin(), p.position.end());
    std::reverse(p.velocity.begin(), p.velocity.end());
    std::reverse(p.drag.begin(), p.drag.end());
    std::reverse(p.foreseen.begin(), p.foreseen.end());
  }
  EXPECT_GT(strongest, 0.5);
}

// So long that such light spheres relax to the gas within them.
TEST(Exchange, MomentumIsConservedOverManyGasSteps) { expectMomentumConserved({2e-3}); }
TEST(Exchange, MomentumIsConservedWhileGasStepsChange) { expectMomentumConserved({2e-3, 1e-3, 4e-3, 5e-4}); }

// Particles are inside the obstacles, too.
TEST(Exchange, MomentumIsConservedAroundObstacles) {
  ObstacleSettings tube, plate;
  tube.x = 0.04, tube.y = 0.12, tube.radius = 0.02;
  plate.shape = ObstacleShape::segment;
  plate.x1 = 0.03, plate.y1 = 0.2, plate.x2 = 0.096, plate.y2 = 0.23;
  plate.thickness = 0.01;
  expectMomentumConserved({2e-3}, {tube, plate});
}

/// Everything the exchange leaves behind after a few steps of particles in four blocks.
struct Outcome {
  std::vector<Vec2> external, foreseen;
  std::vector<double> drag, coefficient, source, voidage;

  explicit Outcome(int threads) {
    CoupledBed bed(unevenScene(), 5003, threads);
    for (int step = 0; step < 3; ++step) {
      bed.gasStep();
      bed.particleSteps(10, bed.scene.gas->step);
    }
    external = bed.particles.external;
    foreseen = bed.particles.foreseen;
    drag = bed.particles.drag;
    coefficient = bed.gas.exchange().coefficient;
    source = bed.gas.exchange().source;
    voidage = bed.voidage.voidage();
  }
  bool operator==(const Outcome&) const = default;
};

TEST(Exchange, SameBitsForAnyNumberOfThreads) {
  const Outcome alone(1);
  for (int threads : {2, 3, 4, 7}) EXPECT_TRUE(Outcome(threads) == alone) << threads;
}

TEST(Exchange, SameBitsForAnySimdLevel) {
  const Outcome best(1);
  for (SimdLevel level : {SimdLevel::baseline, SimdLevel::avx2})
    if (useSimdLevel(level)) {
      EXPECT_TRUE(Outcome(1) == best) << simdLevelNames()[static_cast<std::size_t>(level)];
    }
  useSimdLevel(bestSimdLevel());
}

}  // namespace
}  // namespace bedmix
