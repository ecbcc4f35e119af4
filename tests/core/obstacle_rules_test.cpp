// SPDX-License-Identifier: MIT
#include "engine/core/obstacle_rules.h"

#include "tests/core/spoiled_scene.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

constexpr const char* soundObstacles = R"(
[bed]
width = 0.1
height = 0.2
thickness = 0.004
[[obstacles]]
shape = "circle"
x = 0.05
y = 0.1
radius = 0.02
[[obstacles]]
shape = "segment"
x1 = 0.0
y1 = 0.05
x2 = 0.02
y2 = 0.04
thickness = 0.002
[floor.vibration]
amplitude = 0.005
frequency = 10.0
[particles]
count = 10
diameter = 0.004
density = 1500.0
[contacts]
stiffness = 2000.0
restitution = 0.9
[contacts.friction]
[time]
duration = 0.1
step = 1e-5
[gas.grid]
columns = [[10, 0.01]]
rows = [[20, 0.01]]
[[gas.inlets]]
from = 0.0
to = 0.1
velocity = 1.0
)";

Scene obstacleScene() {
  Result<Scene> scene = readScene(soundObstacles, "");
  EXPECT_TRUE(scene) << (scene ? "" : scene.problems.front().message);
  return scene ? *scene : Scene();
}

void makeDrum(Scene& s) {
  s.gas.reset();
  s.obstacles.pop_back();
  s.obstacles[0].shape = ObstacleShape::drum;
  s.obstacles[0].radius = 0.05;
}

using test::Spoiled;

class ObstacleRule : public ::testing::TestWithParam<Spoiled> {};

TEST(ObstacleRules, SoundScenesBreakNone) {
  Scene scene = obstacleScene();
  EXPECT_TRUE(contradictions(scene).empty());
  makeDrum(scene);
  scene.obstacles[0].spinRpm = -20.0;
  EXPECT_TRUE(contradictions(scene).empty());
}

TEST(ObstacleRules, ReadWhatIsWritten) {
  const Scene scene = obstacleScene();
  const Result<Scene> again = readScene(writeScene(scene), "");
  ASSERT_TRUE(again);
  ASSERT_EQ(again->obstacles.size(), 2u);
  EXPECT_EQ(again->obstacles[1].shape, ObstacleShape::segment);
  EXPECT_EQ(again->obstacles[1].thickness, 0.002);
  EXPECT_EQ(again->floor.vibration->amplitude, 0.005);
}

TEST_P(ObstacleRule, IsReportedOnceWithItsReason) { test::expectReportedOnce(obstacleScene(), GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Scene, ObstacleRule,
    ::testing::Values(
        Spoiled{"NoRadius", [](Scene& s) { s.obstacles[0].radius.reset(); }, "obstacles.0.radius",
                "a circle needs radius"},
        Spoiled{"CircleWithEnds", [](Scene& s) { s.obstacles[0].x1 = 0.0; }, "obstacles.0.x1", "has no x1"},
        Spoiled{"FarAway", [](Scene& s) { s.obstacles[0].x = 0.2; }, "obstacles.0.x", "outside the bed"},
        Spoiled{"SmoothSpin",
                [](Scene& s) {
                  s.obstacles[0].spinRpm = 10.0;
                  s.contacts.friction.reset();
                },
                "obstacles.0.spin_rpm", "contacts.friction"},
        Spoiled{"SegmentWithoutEnd", [](Scene& s) { s.obstacles[1].y2.reset(); }, "obstacles.1.y2",
                "a segment needs y2"},
        Spoiled{"SegmentThatTurns", [](Scene& s) { s.obstacles[1].spinRpm = 1.0; }, "obstacles.1.spin_rpm",
                "has no spin_rpm"},
        Spoiled{"PointSegment",
                [](Scene& s) {
                  s.obstacles[1].x2 = 0.0;
                  s.obstacles[1].y2 = 0.05;
                },
                "obstacles.1.x2", "the same point"},
        Spoiled{"SegmentThroughTheWall", [](Scene& s) { s.obstacles[1].x2 = 0.11; }, "obstacles.1.x2",
                "outside the bed"},
        Spoiled{"DrumWithGas", [](Scene& s) { s.obstacles[0].shape = ObstacleShape::drum; },
                "obstacles.0.shape", "leave out [gas]"},
        Spoiled{"DrumThroughTheWall",
                [](Scene& s) {
                  makeDrum(s);
                  s.obstacles[0].x = 0.06;
                },
                "obstacles.0.radius", "beyond the bed"},
        Spoiled{"NarrowDrum",
                [](Scene& s) {
                  makeDrum(s);
                  s.obstacles[0].radius = 0.007;
                },
                "obstacles.0.radius", "too narrow"},
        Spoiled{"TwoDrums",
                [](Scene& s) {
                  makeDrum(s);
                  s.obstacles.push_back(s.obstacles[0]);
                },
                "obstacles.1.shape", "one drum only"},
        Spoiled{"BlockedInlet",
                [](Scene& s) {
                  s.obstacles[1].y1 = 0.03;
                  s.obstacles[1].x2 = 0.03;
                  s.obstacles[1].y2 = 0.0;
                },
                "gas.inlets.0.from", "obstacles close the gas cell"},
        Spoiled{"WideVibration", [](Scene& s) { s.floor.vibration->amplitude = 0.006; },
                "floor.vibration.amplitude", "half a gas cell"},
        Spoiled{"FastVibration", [](Scene& s) { s.floor.vibration->frequency = 500.0; },
                "floor.vibration.frequency", "within a contact"}),
    test::nameOfSpoiled);

}  // namespace
}  // namespace bedmix
