// SPDX-License-Identifier: MIT
#include "engine/core/scene_reader.h"
#include "engine/core/state_bytes.h"
#include "engine/core/steering.h"
#include "engine/simulation.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <string>

namespace bedmix::test {
namespace {

/// As large as several blocks of particles, with gas, walls and contacts.
Scene warmScene() {
  Scene scene = lowScene(3000, 2.0);
  scene.bed.width = 0.24;
  scene.bed.height = 0.36;
  scene.gas->grid = {{{20, 0.012}}, {{30, 0.012}}};
  scene.gas->inlets = {{0.0, 0.24, 2.0, std::nullopt}};
  scene.start.arrangement = Arrangement::drop;
  auto& heat = scene.effects.at<HeatSettings>().emplace();
  heat.heatCapacity = 840.0;
  heat.conductivity = 1.0;
  heat.tracerTemperature = 400.0;
  heat.wallTemperature = 320.0;
  heat.gas.emplace();
  heat.gas->inletTemperature = 350.0;
  return scene;
}

Simulation resumed(const Simulation& from, const Scene& scene, int threads) {
  StateWriter out(0);
  from.save(out);
  const std::vector<std::byte> bytes = out.take();
  StateReader in(bytes);
  std::optional<Simulation> simulation = Simulation::make(scene, in, threads);
  EXPECT_TRUE(simulation && in.done());
  return std::move(*simulation);
}

TEST(HeatScene, ThreadsAndBreaksChangeNothing) {
  const Scene scene = warmScene();
  Simulation whole = simulate(scene);
  ASSERT_FALSE(whole.advance(2000));
  Simulation broken = simulate(scene, 3);
  ASSERT_FALSE(broken.advance(1005));  // within a gas step
  Simulation rest = resumed(broken, scene, 2);
  ASSERT_FALSE(rest.advance(995));
  EXPECT_EQ(whole.stateHash(), rest.stateHash());
  EXPECT_EQ(whole.frame()->temperature, rest.frame()->temperature);
  EXPECT_EQ(whole.frame()->gas.temperature, rest.frame()->gas.temperature);
}

TEST(HeatScene, HeatDoesNotMoveTheBed) {
  Scene scene = warmScene();
  Simulation warm = simulate(scene);
  scene.effects.at<HeatSettings>().reset();
  Simulation plain = simulate(scene);
  ASSERT_FALSE(warm.advance(500) || plain.advance(500));
  EXPECT_EQ(warm.frame()->position, plain.frame()->position);
  EXPECT_EQ(warm.frame()->gas.velocity, plain.frame()->gas.velocity);
  EXPECT_TRUE(plain.frame()->temperature.empty() && plain.frame()->gas.temperature.empty());
}

std::string complaint(const Scene& scene) {
  const std::vector<Contradiction> broken = contradictions(scene);
  return broken.size() == 1 ? broken.front().path + ": " + broken.front().message : "";
}

TEST(HeatScene, ContradictionsAreNamed) {
  Scene scene = warmScene();
  EXPECT_TRUE(contradictions(scene).empty());
  HeatSettings& heat = *scene.effects.at<HeatSettings>();
  heat.gas.reset();
  EXPECT_NE(complaint(scene).find("heat.gas: [heat] needs the table [heat.gas]"), std::string::npos);
  heat.gas.emplace();
  heat.heatCapacity = 1e-3;
  EXPECT_NE(complaint(scene).find("gas.step: a step of 0.0001 s is too long"), std::string::npos);
  heat.youngsModulus = 1e17;
  EXPECT_EQ(complaint(scene), "");
  scene.gas.reset();
  EXPECT_NE(complaint(scene).find("there is no [gas]"), std::string::npos);
}

TEST(HeatScene, IsReadAndWritten) {
  const Scene scene = warmScene();
  const Result<Scene> again = readScene(writeScene(scene), "test");
  ASSERT_TRUE(again) << toString(again.problems.front());
  EXPECT_EQ(writeScene(*again), writeScene(scene));
  EXPECT_EQ(again->effects.find<HeatSettings>()->gas->inletTemperature, 350.0);
}

TEST(HeatScene, InletTemperatureCanBeSteered) {
  const Scene scene = warmScene();
  const auto steered = [&](const std::string& path, const std::string& value) {
    return steeredScene(scene, {{path, value}});
  };
  const Result<Scene> warmer = steered("heat.gas.inlet_temperature", "500");
  ASSERT_TRUE(warmer) << toString(warmer.problems.front());
  EXPECT_EQ(warmer->effects.find<HeatSettings>()->inletTemperature(), 500.0);
  EXPECT_FALSE(steered("heat.temperature", "500"));
  EXPECT_FALSE(steered("heat.tracer_temperature", "500"));
  EXPECT_FALSE(steered("heat", ""));
}

}  // namespace
}  // namespace bedmix::test
