// SPDX-License-Identifier: MIT
#include "tests/gas/gas_scenes.h"
#include "tests/hard/hard_beds.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

/// What a run says that is stopped within `steps`.
std::string stopOf(Simulation simulation, std::int64_t steps = 1000) {
  const auto trouble = simulation.advance(steps);
  return trouble ? *trouble : "";
}

void expectWords(const std::string& message, std::initializer_list<const char*> words) {
  for (const char* word : words) EXPECT_NE(message.find(word), std::string::npos) << word << ": " << message;
}

Scene sceneOf(std::size_t particles) {
  Scene scene = test::lowScene(static_cast<std::int64_t>(particles), 1.0);
  return scene;
}

Simulation bedAt(const Scene& scene, const std::vector<Vec2>& places) {
  return Simulation::make(scene, makeParticles(scene, places));
}

TEST(Guards, OverlapNamesParticleStageTimeAndCure) {
  expectWords(stopOf(bedAt(sceneOf(3), {{0.01, 0.05}, {0.02, 0.05}, {0.0215, 0.05}})),
              {"particle 1 ", "of a diameter", "(contacts)", "t = 1e-05 s", "contacts.stiffness"});
}

TEST(Guards, SpeedNamesParticleStageTimeAndCure) {
  const Scene scene = sceneOf(2);
  Particles start = makeParticles(scene, {{0.01, 0.05}, {0.03, 0.05}});
  start.velocity[1].y = 300.0;
  expectWords(stopOf(Simulation::make(scene, std::move(start))),
              {"particle 1 ", "of its diameter in a step", "(integrate)", "t = 0.0001 s", "time.step"});
}

TEST(Guards, NonFiniteNamesParticleStageTimeAndCure) {
  const Scene scene = sceneOf(2);
  Particles start = makeParticles(scene, {{0.01, 0.05}, {0.03, 0.05}});
  start.velocity[0].x = std::numeric_limits<double>::quiet_NaN();
  expectWords(stopOf(Simulation::make(scene, std::move(start))),
              {"particle 0 ", "no longer finite", "(start)", "t = 0 s", "time.step"});
}

// 40 spheres in one place's reach, of which none is said to overlap.
TEST(Guards, VoidageNamesCellStageTimeAndCure) {
  std::vector<Vec2> places;
  for (int i = 0; i < 40; ++i) places.push_back({0.016 + 0.0005 * (i % 8), 0.04 + 0.0005 * (i / 8)});
  Scene scene = sceneOf(places.size());
  scene.limits.maxOverlap = 1.0;
  scene.time.step = 1e-7;
  scene.gas->step = 1e-6;
  expectWords(stopOf(bedAt(scene, places)),
              {"in the cell at x = 0.018 m, y = 0.042 m", "(voidage)", "t = 1e-06 s", "contacts.stiffness"});
}

TEST(Guards, GasThatIsNotFiniteNamesStageTimeAndCure) {
  Simulation simulation = test::simulate(sceneOf(0));
  simulation.setInlets({{0.0, 0.048, 1e200, std::nullopt}});
  expectWords(stopOf(std::move(simulation)), {"no finite solution", "(gas)", "t = 0.0001 s", "gas.step"});
}

TEST(Guards, ReportHoldsTheExtremesOfARun) {
  Simulation simulation = bedAt(sceneOf(1), {{0.018, 0.1}});
  ASSERT_EQ(simulation.advance(5000), std::nullopt);
  const StepReport& r = simulation.report();
  const double alone = 1.0 - particleVolume(sceneOf(1)) / (0.012 * 0.012 * 0.004);
  EXPECT_NEAR(r.lowestVoidage, alone, 1e-12);  // it falls through the middle of a column
  EXPECT_EQ(r.largestSpeedParticle, 0);
  EXPECT_NEAR(r.largestSpeed, 9.81 * 0.05, 0.05 * 9.81 * 0.05);
  // Plug flow of 1 m/s but for friction at the walls and the sphere.
  EXPECT_NEAR(r.largestCourant, 1.0 * 1e-4 / 0.012, 0.2 * 1e-4 / 0.012);
}

}  // namespace
}  // namespace bedmix
