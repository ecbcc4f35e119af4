// SPDX-License-Identifier: MIT
#include "engine/core/scene_reader.h"
#include "engine/simulation.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace bedmix {
namespace {

/// An empty bed without gas.
Scene emptyBed() {
  Scene scene = test::lowScene(0, 0.0);
  scene.gas.reset();
  scene.bed.height = 0.3;
  scene.contacts.stiffness = 2e4;
  scene.limits.maxOverlap = 0.2;
  return scene;
}
FeedSettings& feedOf(Scene& scene) { return *scene.effects.at<FeedSettings>(); }
void addFeed(Scene& scene, double rate, std::int64_t most) {
  FeedSettings& feed = scene.effects.at<FeedSettings>().emplace();
  feed.most = most;
  if (rate > 0.0) feed.streams = {{.rate = rate, .from = 0.0, .to = 0.03, .y = 0.25}};
}

/// In so many steps, a state's worth of bytes and back.
Simulation reloaded(const Simulation& simulation, const Scene& scene, int threads = 1) {
  StateWriter out(0);
  simulation.save(out);
  const std::vector<std::byte> bytes = out.take();
  StateReader in(bytes);
  std::optional<Simulation> again = Simulation::make(scene, in, threads);
  EXPECT_TRUE(again && in.done());
  return std::move(*again);
}

/// Who comes in flies a parabola until he leaves, for exactly as long as that takes.
TEST(Feed, ParticlesFallAlongAParabolaAndStayAsLongAsThatTakes) {
  Scene scene = emptyBed();
  scene.contacts.friction.reset();
  scene.bed.width = 0.2;
  addFeed(scene, 100.0, 50);
  FeedStream& stream = feedOf(scene).streams[0];
  stream.vx = 0.1;
  stream.vy = -0.2;
  feedOf(scene).outlets = {{.from = 0.0, .to = 0.2, .bottom = 0.0, .top = 0.05}};
  Simulation simulation = test::simulate(scene);
  struct Flight {
    double x, y, since;
  };
  std::map<std::int32_t, Flight> flights;
  double shortest = infinity, longest = 0.0;
  constexpr std::int64_t stride = 20;  // steps
  for (int i = 0; i < 5000; ++i) {
    ASSERT_EQ(simulation.advance(stride), std::nullopt);
    const FramePtr frame = simulation.frame();
    for (std::size_t p = 0; p < frame->size(); ++p) {
      const Vec2f at = frame->position[p];
      // The time of flight from the speed, since it came in between two looks.
      const double fallen = (-0.2 - static_cast<double>(frame->velocity[p].y)) / scene.gravity;
      const auto [flight, isNew] =
          flights.try_emplace(frame->id[p], Flight{at.x - 0.1 * fallen, 0.25, frame->time - fallen});
      EXPECT_TRUE(!isNew || fallen <= stride * 1e-5 + 1e-6) << fallen;
      const double t = frame->time - flight->second.since;
      EXPECT_NEAR(at.x, flight->second.x + 0.1 * t, 1e-6);
      EXPECT_NEAR(at.y, 0.25 - 0.2 * t - 0.5 * scene.gravity * t * t, 1e-6);
    }
    for (auto flight = flights.begin(); flight != flights.end();) {
      if (std::binary_search(frame->id.begin(), frame->id.end(), flight->first)) {
        ++flight;
        continue;
      }
      shortest = std::min(shortest, frame->time - flight->second.since);
      longest = std::max(longest, frame->time - flight->second.since);
      flight = flights.erase(flight);
    }
  }
  // -0.2 t - g t^2/2 = -0.2 m, and up to an interval and a look later.
  const double fall = (-0.2 + std::sqrt(0.04 + 2.0 * scene.gravity * 0.2)) / scene.gravity;
  const double interval = std::sqrt(0.02 * 0.004 / scene.gravity);
  EXPECT_GE(shortest, fall);
  EXPECT_LE(longest, fall + interval + stride * 1e-5);
  EXPECT_EQ(simulation.report().largestOverlap, 0.0);
}

TEST(Feed, CountsAreThoseOfTheRate) {
  Scene scene = emptyBed();
  addFeed(scene, 150.0, 200);
  feedOf(scene).streams[0].vy = -0.5;
  Simulation simulation = test::simulate(scene);
  ASSERT_EQ(simulation.advance(100000), std::nullopt);
  const FramePtr frame = simulation.frame();
  EXPECT_NEAR(static_cast<double>(frame->size()), 150.0, 1.0);
  for (std::size_t i = 0; i < frame->size(); ++i) EXPECT_EQ(frame->id[i], static_cast<std::int32_t>(i));
  EXPECT_EQ(simulation.report().waitingLargest, 0);
  EXPECT_EQ(frame->species, std::vector<std::uint8_t>(frame->size(), 0));
}

TEST(Feed, WhoFindsNoRoomWaits) {
  Scene scene = emptyBed();
  addFeed(scene, 400.0, 30);
  scene.tracer.rule = TracerRule::fed;
  Simulation simulation = test::simulate(scene);
  ASSERT_EQ(simulation.advance(20000), std::nullopt);  // 80 would have come
  EXPECT_EQ(simulation.frame()->size(), 30u);
  EXPECT_NEAR(static_cast<double>(simulation.report().waitingLargest), 50.0, 1.0);
  EXPECT_EQ(simulation.frame()->species, std::vector<std::uint8_t>(30, 1));

  // A line no longer than two diameters, on which they lie without weight.
  scene.gravity = 0.0;
  feedOf(scene).most = 1000;
  feedOf(scene).streams[0].to = 0.008;
  Simulation still = test::simulate(scene);
  ASSERT_EQ(still.advance(20000), std::nullopt);
  EXPECT_LE(still.frame()->size(), 2u);
  EXPECT_GE(still.report().waitingLargest, 77);
  EXPECT_EQ(still.report().largestOverlap, 0.0);
}

/// Nobody comes in within an obstacle or below an inclined floor.
TEST(Feed, OnlyWithinTheBed) {
  Scene scene = emptyBed();
  scene.bed.width = 0.2;
  scene.gravity = 0.0;
  scene.floor.inclinationDeg = 30.0;
  scene.obstacles.push_back({.shape = ObstacleShape::circle, .x = 0.04, .y = 0.06, .radius = 0.02});
  addFeed(scene, 1e4, 100);
  feedOf(scene).streams[0] = {.rate = 1e4, .from = 0.0, .to = 0.2, .y = 0.06};
  Simulation simulation = test::simulate(scene);
  ASSERT_EQ(simulation.advance(20000), std::nullopt);
  const FramePtr frame = simulation.frame();
  EXPECT_GE(frame->size(), 4u);
  for (const Vec2f at : frame->position) {
    EXPECT_GT(std::hypot(at.x - 0.04, at.y - 0.06), 0.02 + 0.002 - 1e-6);
    EXPECT_GT(at.y, floorHeight(scene, at.x) + 0.002);
  }
}

/// A heap that only its tangential springs hold on a slope: if they were lost as others come and go, it would
/// set off.
TEST(Feed, OthersDoNotNotice) {
  Scene scene = emptyBed();
  scene.bed.width = 0.2;
  scene.particles.count = 60;
  scene.floor.inclinationDeg = 12.0;
  scene.contacts.friction->coefficient = 0.9;
  scene.contacts.rolling.emplace().coefficient = 0.5;
  Scene fed = scene;
  addFeed(fed, 200.0, 100);
  feedOf(fed).streams[0].to = 0.02;
  feedOf(fed).streams[0].vy = -0.8;
  feedOf(fed).outlets = {{.from = 0.0, .to = 0.2, .bottom = 0.15, .top = 0.24}};
  Simulation alone = test::simulate(scene), among = test::simulate(fed);
  const FramePtr start = alone.frame();
  ASSERT_EQ(alone.advance(50000), std::nullopt);
  ASSERT_EQ(among.advance(50000), std::nullopt);
  const FramePtr a = alone.frame(), b = among.frame();
  ASSERT_GE(b->id.back(), 150);
  double moved = 0.0;
  for (std::size_t i = 0; i < 60; ++i) {
    ASSERT_EQ(b->id[i], static_cast<std::int32_t>(i));
    EXPECT_NEAR(a->position[i].x, b->position[i].x, 2e-7);
    EXPECT_NEAR(a->position[i].y, b->position[i].y, 2e-7);
    EXPECT_NEAR(a->angularVelocity[i], b->angularVelocity[i], 1e-3);
    moved = std::max(moved, std::abs(static_cast<double>(a->position[i].x) - start->position[i].x));
  }
  EXPECT_LT(moved, 0.004);
}

/// A particle that appears in gas at rest has taken the place of as much: nothing flows. If it had pushed
/// that much away, gas would have left the cell at some cm/s.
TEST(Feed, MakesNoGasFlow) {
  Scene scene = test::lowScene(20, 0.0);
  scene.start.arrangement = Arrangement::drop;
  scene.gravity = 0.0;
  addFeed(scene, 2000.0, 60);
  for (const double y : {0.06, 0.07, 0.08, 0.09, 0.1})
    feedOf(scene).streams.push_back({.rate = 2000.0, .from = 0.0, .to = 0.048, .y = y});
  feedOf(scene).outlets = {{.from = 0.0, .to = 0.048, .bottom = 0.02, .top = 0.05}};
  Simulation simulation = test::simulate(scene);
  ASSERT_GT(simulation.frame()->size(), 0u);
  ASSERT_EQ(simulation.advance(1000), std::nullopt);
  const FramePtr frame = simulation.frame();
  EXPECT_GT(frame->id.back(), 30);
  for (const Vec2f u : frame->gas.velocity) EXPECT_LT(std::hypot(u.x, u.y), 1e-12f);
  EXPECT_GT(1.0f - *std::min_element(frame->gas.voidage.begin(), frame->gas.voidage.end()), 0.01f);
}

/// Two kinds with sizes of their own, in gas, with temperatures, lift and virtual mass.
Scene wholeBed() {
  Scene scene = test::lowScene(60, 3.0);
  scene.start.arrangement = Arrangement::drop;
  scene.bed.thickness = 0.006;
  scene.particles.species.push_back({"small", 0, 0.003, {}, {}});
  scene.particles.size.emplace();
  HeatSettings& heat = scene.effects.at<HeatSettings>().emplace();
  heat.heatCapacity = 840.0;
  heat.gas.emplace();
  scene.effects.at<LiftSettings>() = {ShearLift::mei, SpinLift::rubinowKeller};
  scene.effects.at<VirtualMassSettings>().emplace();
  addFeed(scene, 100.0, 100);
  feedOf(scene).streams[0].y = 0.1;
  feedOf(scene).streams.push_back(
      {.species = "small", .rate = 200.0, .from = 0.02, .to = 0.048, .y = 0.11, .temperature = 400.0});
  feedOf(scene).outlets = {{.from = 0.04, .to = 0.048, .bottom = 0.02, .top = 0.08}};
  scene.tracer.rule = TracerRule::species;
  return scene;
}

TEST(Feed, ThreadsAndCheckpointsChangeNoBit) {
  const Scene scene = wholeBed();
  ASSERT_TRUE(readScene(writeScene(scene), "")) << readScene(writeScene(scene), "").problems.front().message;
  Simulation whole = test::simulate(scene), two = test::simulate(scene, 2);
  ASSERT_EQ(whole.advance(12340), std::nullopt);
  ASSERT_EQ(two.advance(12340), std::nullopt);
  EXPECT_EQ(whole.stateHash(), two.stateHash());
  Simulation second = reloaded(whole, scene, 2);
  EXPECT_EQ(second.stateHash(), whole.stateHash());
  ASSERT_EQ(whole.advance(12340), std::nullopt);
  ASSERT_EQ(second.advance(12340), std::nullopt);
  EXPECT_EQ(second.stateHash(), whole.stateHash());
  const FramePtr frame = whole.frame();
  EXPECT_EQ(frame->temperature, second.frame()->temperature);
  EXPECT_EQ(frame->radius, second.frame()->radius);
  EXPECT_LT(frame->size(), static_cast<std::size_t>(frame->id.back()) + 1);  // some have left
}

/// More than half of a bed of two blocks of contacts goes at once, and comes again.
TEST(Feed, ListsFollowHowManyThereAre) {
  for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::rk4}) {
    Scene scene = emptyBed();
    scene.bed.width = 0.2;
    scene.particles.count = 2500;
    scene.start.arrangement = Arrangement::drop;
    scene.time.integrator = integrator;
    addFeed(scene, 0.0, 2600);
    for (const double y : {0.9, 1.0, 1.1, 1.2, 1.3})
      feedOf(scene).streams.push_back({.rate = 1e4, .from = 0.12, .to = 0.2, .y = y, .vy = -2.0});
    feedOf(scene).outlets = {{.from = 0.0, .to = 0.11, .bottom = 0.0, .top = 0.8}};
    Simulation whole = test::simulate(scene), two = test::simulate(scene, 2);
    ASSERT_EQ(whole.advance(1000), std::nullopt);
    EXPECT_LT(whole.frame()->size(), 1500u);
    ASSERT_EQ(whole.advance(7000), std::nullopt);
    ASSERT_EQ(two.advance(8000), std::nullopt);
    EXPECT_GT(whole.frame()->size(), 1550u);
    EXPECT_EQ(whole.stateHash(), two.stateHash());
    Simulation again = reloaded(two, scene);
    ASSERT_EQ(whole.advance(2000), std::nullopt);
    ASSERT_EQ(again.advance(2000), std::nullopt);
    EXPECT_EQ(whole.stateHash(), again.stateHash());
  }
}

TEST(Feed, FramesTellKindsSizesAndTemperatures) {
  const Scene scene = wholeBed();
  Simulation simulation = test::simulate(scene);
  ASSERT_EQ(simulation.advance(20000), std::nullopt);
  const FramePtr frame = simulation.frame();
  const std::size_t n = frame->size();
  ASSERT_EQ(frame->radius.size(), n);
  ASSERT_EQ(frame->kind.size(), n);
  ASSERT_EQ(frame->temperature.size(), n);
  ASSERT_TRUE(std::is_sorted(frame->id.begin(), frame->id.end()));
  int small = 0;
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_EQ(frame->species[i], frame->kind[i]);
    if (frame->kind[i] == 0) continue;
    ++small;
    EXPECT_GE(frame->id[i], 60);
    EXPECT_EQ(frame->radius[i], 0.0015f);
    EXPECT_GT(frame->temperature[i], 300.0f);
  }
  EXPECT_GT(small, 5);
}

/// A checkpoint whose particles are none is refused.
TEST(Feed, DamagedCheckpointsAreRefused) {
  const Scene scene = wholeBed();
  Simulation simulation = test::simulate(scene);
  ASSERT_EQ(simulation.advance(5000), std::nullopt);
  StateWriter out(0);
  simulation.save(out);
  std::vector<std::byte> bytes = out.take();
  bytes[1] = std::byte{0x10};  // of the number of particles
  StateReader in(bytes);
  EXPECT_FALSE(Simulation::make(scene, in));
}

}  // namespace
}  // namespace bedmix
