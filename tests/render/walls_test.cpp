// SPDX-License-Identifier: MIT
#include "render/draw_walls.h"
#include "tests/render/bed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace bedmix {
namespace {

constexpr float em = 10.0f;
constexpr Camera camera{{100.0f, 900.0f}, 2000.0f};  // 2 px per mm

DrawList walls(const Scene& scene) {
  DrawList list;
  list.clip = {0.0f, 20.0f, 400.0f, 1000.0f};
  drawWalls(list, scene, camera, em);
  return list;
}

std::vector<Line> ofColor(const DrawList& list, Rgba color) {
  std::vector<Line> found;
  std::copy_if(list.lines.begin(), list.lines.end(), std::back_inserter(found),
               [&](const Line& line) { return line.color == color; });
  return found;
}

TEST(DrawWalls, StandOutsideTheRoomOfTheParticles) {
  const DrawList list = walls(test::gaslessBed());
  ASSERT_EQ(list.lines.size(), 3u);
  const Line &left = list.lines[0], &floor = list.lines[1], &right = list.lines[2];
  EXPECT_FLOAT_EQ(left.from.x + 0.5f * left.width, 100.0f);
  EXPECT_FLOAT_EQ(floor.from.y - 0.5f * floor.width, 900.0f);
  EXPECT_FLOAT_EQ(right.from.x - 0.5f * right.width, 292.0f);
  EXPECT_FLOAT_EQ(left.from.y, 20.0f);  // 100 m high in the scene, up to the view's edge here
  EXPECT_TRUE(list.triangles.empty());
}

TEST(DrawWalls, ALidClosesTheBed) {
  Scene scene = test::gaslessBed();
  scene.bed.top = BedTop::lid;
  const DrawList list = walls(scene);
  ASSERT_EQ(list.lines.size(), 4u);
  EXPECT_FLOAT_EQ(list.lines[3].from.y + 0.5f * list.lines[3].width, 60.0f);  // 420 mm up
}

TEST(DrawWalls, AMovingFloorIsDrawnWhereItIs) {
  Scene scene = test::gaslessBed();
  scene.floor.vibration = VibrationSettings{0.01, 1.0};
  for (const auto& [time, y, solids] :
       {std::tuple{0.0, 900.0f, 0u}, {0.25, 880.0f, 2u}, {0.75, 920.0f, 0u}}) {
    DrawList list;
    list.clip = {0.0f, 20.0f, 400.0f, 1000.0f};
    drawWalls(list, scene, camera, em, {}, time);
    ASSERT_EQ(list.lines.size(), 3u);
    EXPECT_NEAR(list.lines[1].from.y - 0.5f * list.lines[1].width, y, 1e-3f);
    EXPECT_EQ(list.triangles.size(), solids);
  }
}

TEST(DrawWalls, ADrumIsAllThereIs) {
  Scene scene = test::gaslessBed();
  scene.obstacles.emplace_back();
  scene.obstacles[0].shape = ObstacleShape::drum;
  scene.obstacles[0].x = 0.048, scene.obstacles[0].y = 0.06, scene.obstacles[0].radius = 0.04;
  const DrawList list = walls(scene);
  ASSERT_GT(list.lines.size(), 60u);
  const Vec2f centre = camera.toPixel(Vec2{0.048, 0.06});
  for (const Line& line : list.lines) {
    const Vec2f middle = (line.from + line.to) * 0.5f;
    EXPECT_NEAR(norm(middle - centre) - 0.5f * line.width, 80.0f, 0.1f);
  }
}

TEST(DrawWalls, AnInclineStandsOnASolid) {
  const DrawList list = walls(test::inclinedBed());
  ASSERT_EQ(list.triangles.size(), 2u);
  EXPECT_EQ(list.triangles[0].color, distributorColor);
  EXPECT_FLOAT_EQ(list.triangles[0].b.y, 900.0f - 2000.0f * 0.096f * std::tan(0.1f * 3.14159265f));
}

TEST(DrawWalls, AStairIsDrawnAsParticlesMeetIt) {
  Scene scene = test::inclinedBed();
  scene.floor.shape = FloorShape::stair;
  // Columns rise 0-0-1-1-1-2-2-2 rows: the two upper treads stand on solid.
  EXPECT_EQ(walls(scene).triangles.size(), 4u);
}

TEST(DrawWalls, InletsAreHolesAboveArrowsAsLongAsTheGasIsFast) {
  const DrawList list = walls(test::inclinedBed());
  const std::vector<Line> holes = ofColor(list, white), arrows = ofColor(list, gasColor);
  ASSERT_FALSE(holes.empty());
  for (const Line& hole : holes) {
    const double x = (hole.from.x - 100.0f) / 2000.0f;
    EXPECT_TRUE((x > 0.0 && x < 0.024) || (x > 0.072 && x < 0.096)) << x;
  }
  ASSERT_GE(arrows.size(), 2u);
  for (const Line& arrow : arrows) EXPECT_LT(arrow.to.y, arrow.from.y);
  const float slow = arrows.back().from.y - arrows.back().to.y;
  const float fast = arrows.front().from.y - arrows.front().to.y;
  EXPECT_NEAR(slow / fast, 3.0 / 5.0, 1e-5);
}

}  // namespace
}  // namespace bedmix
