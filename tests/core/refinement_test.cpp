// SPDX-License-Identifier: MIT
#include "engine/core/refinement.h"

#include "engine/core/scene_reader.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

constexpr Refinement each[] = {{1, 0}, {1, 1}, {2, 1}, {3, 0}, {3, 3}};

TEST(Refinement, KeepsEveryTimeAndAllThatMustDivide) {
  Scene scene = test::paperScene(2.6);
  for (const double step : {1e-5, 5e-6, 3e-6, 1.25e-6, 7e-7}) {
    scene.time.step = step;
    scene.gas->step = 10.0 * step;
    scene.sampling.interval = 1000.0 * step;
    scene.time.duration = 1e6 * step;
    for (const Refinement further : each) {
      const Scene fine = refined(scene, further);
      const std::int64_t finer = std::int64_t{1} << further.particles;
      EXPECT_EQ(fine.refinement, further);
      EXPECT_EQ(stepsPerStep(fine, scene), finer);
      EXPECT_EQ(stepsPerFrame(fine), finer * stepsPerFrame(scene));
      EXPECT_EQ(totalSteps(fine), finer * totalSteps(scene));
      EXPECT_EQ(stepsPerGasStep(fine) << further.gas, finer * stepsPerGasStep(scene));
      for (std::int64_t at : {0, 1, 7, 999, 1000, 123456, 1000000})
        EXPECT_EQ(timeOfStep(fine, finer * at), timeOfStep(scene, at)) << step << ", step " << at;
      EXPECT_TRUE(contradictions(fine).empty());
    }
  }
}

TEST(Refinement, OfAutomaticStepsDividesTheError) {
  Scene scene = test::paperScene(2.6);
  scene.time.step = scene.gas->step = StepLength::automatic();
  const Scene fine = refined(scene, {2, 1});
  EXPECT_EQ(fine.time.error, scene.time.error / 16.0);
  EXPECT_EQ(fine.gas->error, scene.gas->error / 2.0);
  EXPECT_EQ(stepsPerStep(fine, scene), 1);
  EXPECT_EQ(writeScene(unrefined(fine)), writeScene(scene));
  scene.gas->step = 1e-4;  // then ticks are gas steps
  EXPECT_EQ(stepsPerStep(refined(scene, {2, 1}), scene), 2);
  scene.time.step = 1e-5;
  scene.gas->step = StepLength::automatic();  // then they are the particles'
  EXPECT_EQ(stepsPerStep(refined(scene, {2, 1}), scene), 4);
}

TEST(Refinement, CanBeUndoneAndTakenInParts) {
  const Scene scene = test::paperScene(2.6);
  for (const Refinement further : each) {
    const Scene fine = refined(scene, further);
    EXPECT_EQ(writeScene(unrefined(fine)), writeScene(scene));
    EXPECT_EQ(unrefined(fine).refinement, Refinement{});
    EXPECT_EQ(writeScene(refined(refined(scene, {1, 0}), {further.particles - 1, further.gas})),
              writeScene(fine));
  }
}

TEST(Refinement, NamesTheSettingsItChanges) {
  using Settings = std::vector<std::pair<std::string, double>>;
  Scene scene = test::paperScene(2.6);
  EXPECT_EQ(refinedSettings(refined(scene, {2, 0})), (Settings{{"time.step", 2.5e-6}}));
  EXPECT_EQ(refinedSettings(refined(scene, {1, 1})), (Settings{{"time.step", 5e-6}, {"gas.step", 5e-5}}));
  scene.gas.reset();
  EXPECT_EQ(refinedSettings(refined(scene, {1, 0})), (Settings{{"time.step", 5e-6}}));
}

}  // namespace
}  // namespace bedmix
