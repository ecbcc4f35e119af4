// SPDX-License-Identifier: MIT
#include "render/draw_forces.h"

#include "render/scales.h"
#include "tests/render/bed.h"
#include "tests/render/drawn.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bedmix {
namespace {

TEST(Forces, AreStiffnessTimesOverlap) {
  const Scene scene = test::flatBed();  // 2000 N/m, 4 mm
  const Frame frame = test::particlesAt({{0.0400f, 0.1f}, {0.0439f, 0.1f}, {0.0479f, 0.1f}}, {});
  const std::vector<FrameContact> contacts = contactsOf(frame, scene);
  // The second pair is 4.0 mm apart up to rounding.
  ASSERT_FALSE(contacts.empty());
  EXPECT_NEAR(contacts[0].force, 0.2, 2e-4);
  EXPECT_EQ(contacts[0].from, frame.position[0]);
  EXPECT_EQ(contacts[0].to, frame.position[1]);
  for (std::size_t i = 1; i < contacts.size(); ++i) EXPECT_LT(contacts[i].force, 1e-4);
}

TEST(Forces, OfWallsEndOnThem) {
  const Frame frame = test::particlesAt({{0.0019f, 0.1f}}, {{0.05f, 0.0018f}});
  const std::vector<FrameContact> contacts = contactsOf(frame, test::flatBed());
  ASSERT_EQ(contacts.size(), 2u);  // the particle by the floor is in a lower cell
  EXPECT_NEAR(contacts[0].force, 0.4, 1e-3);
  EXPECT_NEAR(contacts[0].to.y, 0.0, 1e-7);
  EXPECT_NEAR(contacts[1].force, 0.2, 1e-3);
  EXPECT_NEAR(contacts[1].to.x, 0.0, 1e-7);
}

// Drawn at both sides.
TEST(Forces, GoAcrossPeriodicSides) {
  Scene scene = test::flatBed();
  scene.bed.sides = BedSides::periodic;
  const auto width = static_cast<float>(scene.bed.width);
  const Frame frame = test::particlesAt({{0.001f, 0.1f}, {width - 0.0029f, 0.1f}}, {});
  const std::vector<FrameContact> contacts = contactsOf(frame, scene);
  ASSERT_EQ(contacts.size(), 2u);
  for (const FrameContact& c : contacts) EXPECT_NEAR(c.force, 0.2, 2e-3);
  EXPECT_EQ(contacts[0].from, frame.position[0]);
  EXPECT_NEAR(contacts[0].to.x, -0.0029f, 1e-7);
  EXPECT_EQ(contacts[1].to, frame.position[1]);
  EXPECT_NEAR(contacts[1].from.x, width + 0.001f, 1e-7);
}

TEST(Forces, AreFoundWhereverParticlesAre) {
  Scene scene = test::gaslessBed();
  Frame frame = test::movingFrame(scene);   // at 1.25 diameters
  frame.position.push_back({0.05f, 5.0f});  // far above the bed
  frame.position.push_back({0.0531f, 5.001f});
  frame.species.resize(frame.position.size());
  scene.particles.diameter *= 1.3;  // now all neighbours touch
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < frame.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      pairs += static_cast<double>(norm(frame.position[i] - frame.position[j])) < scene.particles.diameter;
  const std::vector<FrameContact> contacts = contactsOf(frame, scene);
  const auto isPair = [&](const FrameContact& c) {
    return std::find(frame.position.begin(), frame.position.end(), c.to) != frame.position.end();
  };
  EXPECT_EQ(static_cast<std::size_t>(std::count_if(contacts.begin(), contacts.end(), isPair)), pairs);
  EXPECT_GT(pairs, 2500u);
}

TEST(Forces, MakeWideLines) {
  const Scene scene = test::flatBed();
  EXPECT_DOUBLE_EQ(forceScale(scene), 0.1);  // 3 x the bed's 0.493 N over 24 diameters is 0.062 N
  const float diameter = test::camera.length(0.004);
  EXPECT_FLOAT_EQ(forceWidth(scene, test::camera, 0.05), 0.5f * diameter);
  EXPECT_FLOAT_EQ(forceWidth(scene, test::camera, 3.0), diameter);
  // 0.1 and 1 um of overlap: 0.2 and 2 mN, of which the line of the first is 0.02 px wide.
  const Frame frame =
      test::particlesAt({{0.04f, 0.1f}, {0.0439999f, 0.1f}}, {{0.04f, 0.2f}, {0.04398f, 0.2f}});
  const DrawList list = test::drawn(scene, frame, {Layer::forces});
  ASSERT_EQ(list.lines.size(), 2u);
  EXPECT_EQ(list.lines[1].color, forceColor);
  EXPECT_NEAR(list.lines[1].width, 0.4f * diameter, 0.01f);
}

}  // namespace
}  // namespace bedmix
