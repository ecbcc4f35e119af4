// SPDX-License-Identifier: MIT
#include "render/history.h"

#include "tests/render/bed.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bedmix {
namespace {

Style trailOf(std::int64_t id, double seconds) {
  Style style{Layer::trails};
  style.trails = {id};
  style.trailTime = seconds;
  return style;
}

Frame at(double time) { return test::particlesAt({{0.0f, 0.0f}}, {{static_cast<float>(time), 1.0f}}, time); }

TEST(History, TrailsLastAsLongAsTheStyleSays) {
  History history(test::flatBed(), trailOf(1, 0.3));
  for (int i = 0; i <= 10; ++i) history.observe(at(0.1 * i));
  ASSERT_EQ(history.trail(0).size(), 4u);
  EXPECT_DOUBLE_EQ(history.trail(0).front().time, 0.1 * 7);
  EXPECT_DOUBLE_EQ(history.trail(0).back().time, 0.1 * 10);
  EXPECT_EQ(history.trail(0).back().position.x, 1.0f);
}

TEST(History, TrailsOfManyFramesAreThinnedEvenly) {
  History history(test::flatBed(), trailOf(1, 1.0));
  std::size_t longest = 0;
  for (int i = 0; i <= 30000; ++i) {
    history.observe(at(1e-4 * i));
    longest = std::max(longest, history.trail(0).size());
  }
  EXPECT_LE(longest, History::mostPoints);
  const auto trail = history.trail(0);
  EXPECT_GT(trail.size(), History::mostPoints * 9 / 10);
  EXPECT_DOUBLE_EQ(trail.back().time, 1e-4 * 30000);
  for (std::size_t i = 1; i < trail.size(); ++i) EXPECT_LT(trail[i].time - trail[i - 1].time, 0.011);
}

TEST(History, GoesBackWithTheFrames) {
  History history(test::flatBed(), trailOf(1, 1.0));
  for (const double time : {0.1, 0.2, 0.3, 0.2, 0.2}) history.observe(at(time));
  ASSERT_EQ(history.trail(0).size(), 2u);
  EXPECT_EQ(history.trail(0).back().time, 0.2);
}

std::vector<std::uint16_t> classesOf(const History& history, const Frame& frame) {
  std::vector<std::uint16_t> classes;
  for (const std::int32_t id : frame.id) classes.push_back(history.startClass(id).value());
  return classes;
}

TEST(History, ClassesOfHeightHoldAsManyParticlesEach) {
  Style style{Layer::particles};
  style.color = ParticleColor::height;
  style.classes = 3;
  const Scene scene = test::flatBed();
  History history(scene, style);
  const Frame frame = test::movingFrame(scene);
  history.observe(frame);
  const auto classes = classesOf(history, frame);
  ASSERT_EQ(classes.size(), 1000u);
  float highest[3] = {};
  for (std::size_t i = 0; i < 1000; ++i)
    highest[classes[i]] = std::max(highest[classes[i]], frame.position[i].y);
  EXPECT_EQ(std::count(classes.begin(), classes.end(), 0), 334);
  EXPECT_EQ(std::count(classes.begin(), classes.end(), 2), 333);
  for (std::size_t i = 0; i < 1000; ++i)
    if (classes[i] > 0) {
      EXPECT_GE(frame.position[i].y, highest[classes[i] - 1]);
    }
}

TEST(History, StripsAreEquallyWide) {
  Style style{Layer::particles};
  style.color = ParticleColor::strips;
  style.classes = 4;
  History history(test::flatBed(), style);
  const Frame frame = test::particlesAt({{0.0f, 0.1f}, {0.0239f, 0.1f}, {0.0241f, 0.1f}},
                                        {{0.05f, 0.0f}, {0.096f, 0.0f}, {0.097f, 0.0f}});
  history.observe(frame);
  EXPECT_EQ(classesOf(history, frame), (std::vector<std::uint16_t>{0, 0, 1, 2, 3, 3}));
}

TEST(History, ClassesStayWithTheParticlesWhereOthersLeave) {
  Style style{Layer::particles};
  style.color = ParticleColor::strips;
  style.classes = 4;
  History history(test::flatBed(), style);
  Frame frame = test::particlesAt({{0.0f, 0.1f}, {0.03f, 0.1f}}, {{0.05f, 0.0f}, {0.09f, 0.0f}});
  frame.id = {3, 7, 8, 20};
  history.observe(frame);
  frame.id = {7, 9, 20, 21};
  history.observe(frame);
  EXPECT_EQ(history.startClass(7), 1);
  EXPECT_EQ(history.startClass(20), 3);
  for (const int late : {0, 9, 21}) EXPECT_FALSE(history.startClass(late)) << late;
}

TEST(History, KeepsNothingForAStyleWithoutNeeds) {
  const Scene scene = test::flatBed();
  History history(scene, defaultLayers);
  history.observe(test::movingFrame(scene));
  EXPECT_FALSE(history.startClass(0));
  EXPECT_EQ(history.trails(), 0u);
}

}  // namespace
}  // namespace bedmix
