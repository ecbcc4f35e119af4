// SPDX-License-Identifier: MIT
#include "engine/core/hash.h"
#include "engine/core/rng.h"
#include "engine/core/scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

/// The particles and the gas of Tian et al. (2007), Table 1.
Scene paperScene() {
  Scene scene;
  scene.contacts.restitution = 0.9;
  scene.gas.emplace();
  return scene;
}

TEST(SceneNumbers, AreThePapers) {
  const Scene scene = paperScene();
  const double umf = minimumFluidizationVelocity(scene);
  EXPECT_NEAR(umf, 1.2896, 5e-5);  // given, cut off, as 1.289 m/s
  EXPECT_NEAR(umf * scene.gas->density * scene.particles.diameter / scene.gas->viscosity, 341.5, 0.05);
  EXPECT_NEAR(contactTimeScale(scene), 9.96e-4, 5e-7);
  EXPECT_NEAR(pairDamping(scene), 0.01503, 5e-6);
  EXPECT_NEAR(wallDamping(scene), 0.01503 * std::numbers::sqrt2, 7e-6);
  EXPECT_NEAR(particleMass(scene), 1500.0 * std::numbers::pi / 6 * 64e-9, 1e-18);
}

TEST(SceneNumbers, DampingGivesBackItsRestitution) {
  const double k = 2000.0, m = 1e-4;
  for (double e : {0.05, 0.276, 0.9, 1.0}) {
    const double zeta = dampingFor(e, k, m) / (2.0 * std::sqrt(m * k));
    EXPECT_NEAR(std::exp(-std::numbers::pi * zeta / std::sqrt(1.0 - zeta * zeta)), e, 1e-12);
  }
  Scene scene = paperScene();
  scene.contacts.restitution.reset();
  scene.contacts.damping = 0.17;
  EXPECT_EQ(pairDamping(scene), 0.17);
  EXPECT_EQ(wallDamping(scene), 0.17);
  EXPECT_FALSE(std::signbit(dampingFor(1.0, 2000.0, 5e-5)));  // steps are bounded by its inverse
}

TEST(SceneNumbers, SettingsOfOnesOwnComeFirst) {
  Scene scene = paperScene();
  scene.gas->minimumFluidizationVelocity = 1.45;
  EXPECT_EQ(minimumFluidizationVelocity(scene), 1.45);
  EXPECT_NEAR(inletVelocity(scene, {0.0, 1.0, std::nullopt, 2.0}), 2.9, 1e-15);
  EXPECT_EQ(inletVelocity(scene, {0.0, 1.0, 42.0, std::nullopt}), 42.0);
}

TEST(SceneNumbers, FloorRisesToTheRight) {
  Scene scene = paperScene();
  EXPECT_EQ(floorHeight(scene, 0.05), 0.0);
  scene.floor.inclinationDeg = 18.0;
  EXPECT_NEAR(floorHeight(scene, 0.048), 0.0156, 5e-6);
}

TEST(SceneNumbers, StepsAreWhole) {
  Scene scene = paperScene();
  EXPECT_EQ(stepsPerFrame(scene), 1000);
  EXPECT_EQ(stepsPerGasStep(scene), 10);
  EXPECT_EQ(totalSteps(scene), 1000000);
}

TEST(SceneNumbers, TicksFillFramesWhereStepsAreChosen) {
  Scene scene = paperScene();
  scene.time.step = StepLength::automatic();
  EXPECT_EQ(tick(scene), 1e-4);  // the gas's
  EXPECT_EQ(stepsPerGasStep(scene), 1);
  EXPECT_EQ(totalSteps(scene), 100000);
  scene.gas->step = StepLength::automatic();
  EXPECT_EQ(stepsPerFrame(scene), 5040);
  EXPECT_EQ(timeOfStep(scene, 7 * 5040), 0.07);
  scene.sampling.interval = 1.0;  // too long for ticks of a 5040th: they stay below T/100
  EXPECT_EQ(stepsPerFrame(scene), 5040 * 32);
  scene.time.step = 1e-5;
  EXPECT_EQ(tick(scene), 1e-5);
}

TEST(SceneNumbers, TimesOfFramesAreShortDecimals) {
  Scene scene = paperScene();
  for (int frame = 0; frame <= 1000; ++frame) {
    const double expected = std::stod(fmt::format("{}.{:02}", frame / 100, frame % 100));
    EXPECT_EQ(timeOfStep(scene, 1000 * frame), expected);
  }
  scene.time.step = 3e-6;  // no whole number of steps a second
  EXPECT_EQ(timeOfStep(scene, 7), 7 * 3e-6);
}

TEST(Rng, IsSplitMix64) {
  Rng rng(1234567);
  for (std::uint64_t expected : {6457827717110365317ull, 3203168211198807973ull, 9817491932198370423ull,
                                 4593380528125082431ull, 16408922859458223821ull})
    EXPECT_EQ(rng.next(), expected);
}

TEST(Rng, UniformStaysInItsInterval) {
  Rng rng(1);
  double sum = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double u = rng.uniform(-1.0, 3.0);
    ASSERT_GE(u, -1.0);
    ASSERT_LT(u, 3.0);
    sum += u;
  }
  EXPECT_NEAR(sum / 100000, 1.0, 4 * 4.0 / std::sqrt(12.0 * 100000));
}

TEST(StateHash, IsFnv1aAndSeesEveryBit) {
  StateHash text;
  text.add(std::uint64_t{0x6867666564636261});  // "abcdefgh"
  EXPECT_EQ(text.value(), 0x25da8c1836a8d66dull);
  StateHash plus, minus;
  plus.add(0.0);
  minus.add(-0.0);
  EXPECT_NE(plus.value(), minus.value());
}

}  // namespace
}  // namespace bedmix
