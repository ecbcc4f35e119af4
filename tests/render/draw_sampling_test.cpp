// SPDX-License-Identifier: MIT
#include "render/draw_sampling.h"

#include "render/scales.h"
#include "tests/render/bed.h"
#include "tests/render/drawn.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bedmix {
namespace {

using test::camera;
using test::em;

/// Two cells across and one up, 96 x 840 px; the left one holds enough particles.
Scene coarse() {
  Scene scene = test::flatBed();
  scene.sampling.columns = 2;
  scene.sampling.rows = 1;
  scene.sampling.minParticles = 2;
  return scene;
}
Frame threeParticles() {
  return test::particlesAt({{0.01f, 0.02f}}, {{0.03f, 0.3f}, {0.04f, 0.1f}, {0.05f, 0.1f}});
}

TEST(Sampling, HatchesUnusedCellsOnly) {
  DrawList list = test::drawn(coarse(), threeParticles(), {Layer::sampling});
  ASSERT_GT(list.lines.size(), 5u);
  const auto hatching = std::partition(list.lines.begin(), list.lines.end(), [](const Line& line) {
    return line.from.x == line.to.x || line.from.y == line.to.y;
  });
  EXPECT_EQ(hatching - list.lines.begin(), 5);  // the edges
  // In a box of w x h a line begins every half em along both.
  EXPECT_NEAR(static_cast<double>(list.lines.end() - hatching), (96.0 + 840.0) / 5.0, 1.0);
  for (auto line = hatching; line != list.lines.end(); ++line)
    for (const Vec2f& end : {line->from, line->to}) {
      EXPECT_GE(end.x, 196.0f);
      EXPECT_LE(end.x, 292.0f);
      EXPECT_GE(end.y, 60.0f - 1e-3f);
      EXPECT_LE(end.y, 900.0f + 1e-3f);
      EXPECT_FLOAT_EQ(line->from.x + line->from.y, line->to.x + line->to.y);  // at 45 degrees
    }
}

TEST(Counts, StandInUsedCells) {
  const DrawList list = test::drawn(coarse(), threeParticles(), {Layer::counts});
  ASSERT_EQ(list.texts.size(), 2u);
  EXPECT_EQ(list.texts[0].text, "3");
  EXPECT_EQ(list.texts[1].text, "0.33");
  EXPECT_EQ(list.texts[0].at, camera.toPixel(Vec2{0.024, 0.21}));
  EXPECT_EQ(list.texts[0].size, em);
}

TEST(Counts, ShrinkToTheirCellsOrAreRefused) {
  Scene scene = coarse();
  scene.sampling.columns = 9;  // 21.3 px: 0.85 of them hold 4 digits of 0.55 x 8 px
  const Frame frame = test::particlesAt({{0.001f, 0.02f}}, {{0.002f, 0.3f}});
  const DrawList list = test::drawn(scene, frame, {Layer::counts});
  ASSERT_EQ(list.texts.size(), 2u);
  EXPECT_EQ(list.texts[0].size, 8.0f);
  EXPECT_TRUE(countsProblems(scene, camera, em).empty());

  scene.sampling.columns = 12;
  EXPECT_TRUE(test::drawn(scene, frame, {Layer::counts}).texts.empty());
  const std::vector<Diagnostic> problems = countsProblems(scene, camera, em);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("16 x 840 pixels; take a picture 1.2 times"), std::string::npos)
      << problems[0].message;
}

TEST(Flow, IsTheMeanOfTheCellsParticles) {
  const Scene scene = coarse();
  Frame frame = test::particlesAt({}, {{0.01f, 0.1f},
                                       {0.02f, 0.1f},
                                       {0.03f, 0.1f},
                                       {0.04f, 0.2f},
                                       {0.04f, 0.1f},
                                       {0.06f, 0.1f},
                                       {0.07f, 0.1f},
                                       {0.08f, 0.1f},
                                       {0.09f, 0.1f}});
  frame.velocity.assign(9, {0.3f, 0.0f});
  frame.velocity[0] = {0.8f, 0.5f};
  const DrawList list = test::drawn(scene, frame, {Layer::flow});
  ASSERT_EQ(list.lines.size(), 2u);  // rim and arrow; none for the four on the right
  const Line& arrow = list.lines[1];
  const float pxPerSpeed = camera.length(arrowScale(scene, Layer::flow));
  EXPECT_EQ(arrow.color, flowColor);
  EXPECT_NEAR(arrow.to.x - arrow.from.x, 0.4f * pxPerSpeed, 1e-3);
  EXPECT_NEAR(arrow.to.y - arrow.from.y, -0.1f * pxPerSpeed, 1e-3);
  const Vec2 middle = test::metres((arrow.from + arrow.to) * 0.5f);
  EXPECT_NEAR(middle.x, 0.024, 1e-6);
  EXPECT_NEAR(middle.y, 0.21, 1e-6);
}

}  // namespace
}  // namespace bedmix
