// SPDX-License-Identifier: MIT
#include "engine/core/bed_statistics.h"
#include "engine/core/scene_reader.h"
#include "engine/simulation.h"
#include "tests/core/spoiled_scene.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace bedmix {
namespace {

constexpr double gasConstant = 8.314462618;

Scene reactingBed() {
  Scene scene = test::lowScene(60, 0.0);
  scene.gas.reset();
  scene.start.arrangement = Arrangement::drop;
  ReactionSettings& reaction = scene.effects.at<ReactionSettings>().emplace();
  reaction.content = 0.08;
  reaction.rate = 3.0;
  return scene;
}
ReactionSettings& reactionOf(Scene& scene) { return *scene.effects.at<ReactionSettings>(); }
HeatSettings& addHeat(Scene& scene) {
  HeatSettings& heat = scene.effects.at<HeatSettings>().emplace();
  heat.heatCapacity = 800.0;
  heat.temperature = 350.0;
  return heat;
}

FramePtr after(const Scene& scene, std::int64_t steps) {
  Simulation simulation = test::simulate(scene);
  EXPECT_EQ(simulation.advance(steps), std::nullopt);
  return simulation.frame();
}

TEST(Reaction, GoesExponentially) {
  const Scene scene = reactingBed();
  const FramePtr frame = after(scene, 20000);
  ASSERT_EQ(frame->content.size(), 60u);
  for (const float x : frame->content) EXPECT_NEAR(x, 0.08 * std::exp(-3.0 * 0.2), 1e-8);
  EXPECT_NEAR(*meanContent(*frame, scene), 0.08 * std::exp(-0.6), 1e-8);
}

TEST(Reaction, OfConstantRateEnds) {
  Scene scene = reactingBed();
  reactionOf(scene).model = ReactionModel::constantRate;
  reactionOf(scene).rate = 0.3;
  EXPECT_NEAR(after(scene, 10000)->content[7], 0.05, 1e-8);
  EXPECT_EQ(after(scene, 30000)->content[7], 0.0f);
}

/// Each who comes in has what is left after his own age, whoever he is and whatever he meets; so that what
/// leaves a bed has the mean of exp(-k t) over its residence times (Danckwerts 1953).
TEST(Reaction, ThoseWhoComeInAreAsOldAsTheyAre) {
  Scene scene = reactingBed();
  scene.particles.count = 0;
  FeedSettings& feed = scene.effects.at<FeedSettings>().emplace();
  feed.most = 100;
  feed.streams = {{.rate = 100.0, .from = 0.0, .to = 0.048, .y = 0.1, .vy = -0.5}};
  Simulation simulation = test::simulate(scene);
  std::map<std::int32_t, double> since;
  for (int i = 0; i < 40; ++i) {
    ASSERT_EQ(simulation.advance(stepsPerFrame(scene)), std::nullopt);
    const FramePtr frame = simulation.frame();
    for (std::size_t p = 0; p < frame->size(); ++p) {
      const double age = std::log(0.08 / static_cast<double>(frame->content[p])) / 3.0;
      const auto [entry, isNew] = since.try_emplace(frame->id[p], frame->time - age);
      if (isNew) {
        EXPECT_LT(age, scene.sampling.interval);
      } else {
        EXPECT_NEAR(frame->time - entry->second, age, 1e-6);
      }
    }
  }
  EXPECT_GT(since.size(), 30u);
}

/// A reaction that gives heat q warms a particle by q X_0/c in all, and at any time by q (X_0 - X)/c.
TEST(Reaction, WarmsByWhatHasGone) {
  for (const double heat : {5e5, -5e5}) {
    Scene scene = reactingBed();
    addHeat(scene);
    reactionOf(scene).heat = heat;
    reactionOf(scene).activationEnergy = 20e3;
    reactionOf(scene).referenceTemperature = 350.0;
    const FramePtr frame = after(scene, 15000);
    for (std::size_t i = 0; i < 60; ++i)
      EXPECT_NEAR(frame->temperature[i], 350.0 + heat * (0.08 - frame->content[i]) / 800.0, 1e-3);
    EXPECT_LT(frame->content[0], 0.06f);
  }
}

/// At another temperature as much faster as Arrhenius says.
TEST(Reaction, FollowsArrhenius) {
  Scene scene = reactingBed();
  addHeat(scene);
  reactionOf(scene).activationEnergy = 43e3;
  reactionOf(scene).referenceTemperature = 320.0;
  const double rate = 3.0 * std::exp(43e3 / gasConstant * (1.0 / 320.0 - 1.0 / 350.0));
  const FramePtr frame = after(scene, 10000);
  for (const float x : frame->content) EXPECT_NEAR(x, 0.08 * std::exp(-rate * 0.1), 1e-8);
}

/// With gas that heats and a feed: a resumed run is the same to the bit, and what evaporates is what the
/// particles' heat lacks.
TEST(Reaction, CheckpointsChangeNoBit) {
  Scene scene = test::lowScene(60, 3.0);
  scene.start.arrangement = Arrangement::drop;
  addHeat(scene).gas.emplace().inletTemperature = 420.0;
  ReactionSettings& reaction = scene.effects.at<ReactionSettings>().emplace();
  reaction.rate = 5.0;
  reaction.heat = -2e5;
  Simulation whole = test::simulate(scene), two = test::simulate(scene, 2);
  ASSERT_EQ(whole.advance(10000), std::nullopt);
  ASSERT_EQ(two.advance(10000), std::nullopt);
  StateWriter out(0);
  two.save(out);
  const std::vector<std::byte> bytes = out.take();
  StateReader in(bytes);
  std::optional<Simulation> again = Simulation::make(scene, in);
  ASSERT_TRUE(again && in.done());
  ASSERT_EQ(whole.advance(5000), std::nullopt);
  ASSERT_EQ(again->advance(5000), std::nullopt);
  EXPECT_EQ(whole.stateHash(), again->stateHash());
  EXPECT_EQ(whole.frame()->content, again->frame()->content);
}

Scene soundReaction() {
  Scene scene = reactingBed();
  scene.name = "sound";
  return scene;
}
class ReactionRules : public testing::TestWithParam<test::Spoiled> {};
TEST_P(ReactionRules, AreReportedOnce) { test::expectReportedOnce(soundReaction(), GetParam()); }
INSTANTIATE_TEST_SUITE_P(Each, ReactionRules,
                         testing::Values(test::Spoiled{"ArrheniusWithoutHeat",
                                                       [](Scene& s) { reactionOf(s).activationEnergy = 1e4; },
                                                       "reaction.activation_energy", "no [heat]"},
                                         test::Spoiled{"HeatWithoutHeat",
                                                       [](Scene& s) { reactionOf(s).heat = -1e6; },
                                                       "reaction.heat", "no [heat]"},
                                         test::Spoiled{"ColorOfNothing",
                                                       [](Scene& s) {
                                                         s.effects.at<ReactionSettings>().reset();
                                                         s.pictures.emplace().color = ParticleColor::content;
                                                       },
                                                       "pictures.color", "no [reaction]"}),
                         test::nameOfSpoiled);

}  // namespace
}  // namespace bedmix
