// SPDX-License-Identifier: MIT
#include "engine/core/walls.h"
#include "engine/dem/packing.h"
#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

using std::numbers::pi;

WallSegment circleAt(Vec2 centre, double radius) {
  WallSegment wall{centre, centre};
  wall.radius = radius;
  return wall;
}

double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }

class Circle : public testing::TestWithParam<Integrator> {
 protected:
  Circle() {
    scene_.contacts.stiffness = 2e5;
    scene_.time.integrator = GetParam();
    scene_.time.step = 1e-7;
  }

  /// Sends a smooth sphere against a circle of 20 mm about the origin and expects what its tangent plane
  /// would do: the velocity along n turns round times the restitution, that across stays.
  void expectReflection(Vec2 start, Vec2 velocity, Vec2 touch) const {
    const auto solver = solverAt(scene_, {start}, {circleAt({0.0, 0.0}, 0.02)});
    Particles& p = solver->particles();
    p.velocity[0] = velocity;
    bool touched = false, left = false;
    for (int k = 0; k < 2000 && !left; ++k) {
      ASSERT_FALSE(solver->advance(100));
      left = touched && solver->contactCount() == 0;
      touched = touched || solver->contactCount() > 0;
    }
    ASSERT_TRUE(left);
    const Vec2 n = (1.0 / norm(touch)) * touch;
    const Vec2 expected = velocity - (1.9 * dot(velocity, n)) * n;
    EXPECT_NEAR(p.velocity[0].x, expected.x, 1.5e-3 * norm(velocity));
    EXPECT_NEAR(p.velocity[0].y, expected.y, 1.5e-3 * norm(velocity));
    // A central force, whatever happens in the contact.
    EXPECT_NEAR(cross(p.position[0], p.velocity[0]), cross(start, velocity), 1e-9 * norm(start));
  }

  Scene scene_ = smoothSpheres();
};

TEST_P(Circle, SendsSpheresBackFromOutside) {
  for (const double angle : {0.0, 0.5, 1.2, 2.5, 4.0}) {
    const Vec2 touch = 0.022 * Vec2{std::cos(angle), std::sin(angle)};
    const Vec2 velocity = -0.1 * Vec2{std::cos(angle + 0.6), std::sin(angle + 0.6)};
    expectReflection(touch - 1e-4 / 0.1 * velocity, velocity, touch);
  }
}

TEST_P(Circle, SendsSpheresBackFromInside) {
  for (const double angle : {0.0, 0.5, 1.2, 2.5, 4.0}) {
    const Vec2 touch = 0.018 * Vec2{std::cos(angle), std::sin(angle)};
    const Vec2 velocity = 0.1 * Vec2{std::cos(angle + 0.6), std::sin(angle + 0.6)};
    expectReflection(touch - 1e-4 / 0.1 * velocity, velocity, touch);
  }
}

/// Of a sphere let go at 0.05 rad from the lowest point of a bowl of 100 mm radius, s, over five swings.
double swing(const Scene& scene) {
  const double radius = 0.1, angle = 0.05, path = radius - scene.particles.diameter / 2.0;
  const auto solver =
      solverAt(scene, {path * Vec2{std::sin(angle), -std::cos(angle)}}, {circleAt({0.0, 0.0}, radius)});
  const Particles& p = solver->particles();
  double first = 0.0, last = 0.0;
  int crossings = 0;
  for (double before = p.position[0].x; crossings < 11; before = p.position[0].x) {
    EXPECT_FALSE(solver->advance(10));
    const double now = p.position[0].x;
    last += 10.0 * scene.time.step;
    if ((before > 0.0) == (now > 0.0)) continue;
    if (++crossings == 1) first = last;
    if (last > 10.0) return 0.0;
  }
  return (last - first) / 5.0;
}

// A pendulum of length R - r; of an amplitude a its period is longer by 1 + a^2/16.
TEST_P(Circle, SmoothSphereSwingsInABowl) {
  scene_.gravity = 9.81;
  scene_.time.step = 1e-5;
  scene_.contacts.stiffness = 2000.0;
  scene_.contacts.restitution = 0.5;
  const double expected = 2.0 * pi * std::sqrt(0.098 / 9.81) * (1.0 + 0.05 * 0.05 / 16.0);
  EXPECT_NEAR(swing(scene_), expected, 1e-3 * expected);
}

// One that rolls has 7/5 of its inertia.
TEST_P(Circle, RoughSphereRollsInABowl) {
  scene_.gravity = 9.81;
  scene_.time.step = 1e-5;
  scene_.contacts.stiffness = 2000.0;
  scene_.contacts.restitution = 0.5;
  scene_.contacts.friction.emplace();
  const double expected = 2.0 * pi * std::sqrt(1.4 * 0.098 / 9.81) * (1.0 + 0.05 * 0.05 / 16.0);
  EXPECT_NEAR(swing(scene_), expected, 2e-3 * expected);
}

// The wall's friction F changes velocity by F/m and spin by F r/I: with v R - 2/5 r^2 spin constant, slip
// ends where v = 2/7 (w R + 5/2 v0), the spin being 5/2 (v - v0)/r.
TEST_P(Circle, TurningDrumBringsASphereToRoll) {
  scene_.time.step = 1e-5;
  scene_.contacts.stiffness = 2000.0;
  scene_.contacts.restitution = 0.3;
  scene_.contacts.friction.emplace();
  const double radius = 0.05, r = 0.002, turn = 2.0 * pi, start = 0.1;
  WallSegment drum = circleAt({0.0, 0.0}, radius);
  drum.spin = turn;
  const auto solver = solverAt(scene_, {{0.0, -(radius - r)}}, {drum});
  Particles& p = solver->particles();
  p.velocity[0] = {start, 0.0};
  ASSERT_FALSE(solver->advance(300000));
  const double speed = 2.0 / 7.0 * (turn * radius + 2.5 * start);
  EXPECT_NEAR(norm(p.velocity[0]), speed, 2e-3 * speed);
  EXPECT_GT(cross(p.position[0], p.velocity[0]), 0.0);
  const double spin = 2.5 * (speed - start) / r;
  EXPECT_NEAR(p.spin[0], spin, 2e-3 * spin);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Circle, eachIntegrator(), nameOfIntegrator);

/// Wall contacts and direction of the push on a sphere of 2 mm radius, after a first short step.
struct ObstaclePush {
  std::int64_t contacts;
  Vec2 velocity;  // m/s
};
ObstaclePush obstaclePushAt(const Scene& scene, Vec2 centre) {
  Scene short_ = scene;
  short_.time.step = 1e-9;
  const auto solver = solverAt(short_, {centre}, obstacleWalls(scene));
  EXPECT_FALSE(solver->advance(1));
  return {solver->contactCount(), solver->particles().velocity[0]};
}

Scene withSegments(const std::vector<std::array<double, 4>>& ends, std::optional<double> thickness = {}) {
  Scene scene = smoothSpheres();
  for (const auto& [x1, y1, x2, y2] : ends) {
    ObstacleSettings o;
    o.shape = ObstacleShape::segment;
    o.x1 = x1, o.y1 = y1, o.x2 = x2, o.y2 = y2;
    o.thickness = thickness;
    scene.obstacles.push_back(o);
  }
  return scene;
}

TEST(Segment, PushesOnceFromAllSides) {
  for (const double thickness : {0.0, 0.006}) {
    const Scene scene = withSegments({{0.02, 0.05, 0.06, 0.05}},
                                     thickness > 0.0 ? std::optional<double>(thickness) : std::nullopt);
    const double away = 0.0019 + 0.5 * thickness;
    const double speed = scene.contacts.stiffness * 1e-4 / particleMass(scene) * 1e-9;
    const double diagonal = away / std::sqrt(2.0);
    const struct {
      Vec2 centre, direction;
    } cases[] = {{{0.04, 0.05 + away}, {0.0, 1.0}},
                 {{0.04, 0.05 - away}, {0.0, -1.0}},
                 {{0.02 - away, 0.05}, {-1.0, 0.0}},
                 {{0.06 + away, 0.05}, {1.0, 0.0}},
                 {{0.06 + diagonal, 0.05 - diagonal}, {std::sqrt(0.5), -std::sqrt(0.5)}}};
    for (const auto& [centre, direction] : cases) {
      const ObstaclePush push = obstaclePushAt(scene, centre);
      EXPECT_EQ(push.contacts, 1);
      EXPECT_NEAR(push.velocity.x, speed * direction.x, 1e-3 * speed);
      EXPECT_NEAR(push.velocity.y, speed * direction.y, 1e-3 * speed);
    }
    EXPECT_EQ(obstaclePushAt(scene, {0.04, 0.05 + away + 2e-4}).contacts, 0);
  }
}

TEST(Segment, CornerOfTwoPushesOnce) {
  const Scene scene = withSegments({{0.02, 0.02, 0.05, 0.05}, {0.05, 0.05, 0.08, 0.02}});
  EXPECT_EQ(obstaclePushAt(scene, {0.05, 0.0519}).contacts, 1);
  EXPECT_EQ(obstaclePushAt(scene, {0.05, 0.0475}).contacts, 2);  // below it both faces push
}

TEST(ObstaclePacking, NoParticleStartsInsideOne) {
  Scene scene = withSegments({{0.0, 0.05, 0.03, 0.03}, {0.066, 0.03, 0.096, 0.05}}, 0.002);
  scene.gravity = 9.81;
  scene.particles.count = 400;
  scene.start.arrangement = Arrangement::drop;
  ObstacleSettings tube;
  tube.x = 0.048, tube.y = 0.06, tube.radius = 0.012;
  scene.obstacles.push_back(tube);
  for (const double above : {0.0, 0.08}) {
    scene.start.above = above;
    const Result<Particles> start = packBed(scene);
    ASSERT_TRUE(start);
    ASSERT_EQ(start->size(), 400u);
    for (const WallShape& wall : wallShapes(allWalls(scene)))
      for (const Vec2 at : start->position) {
        EXPECT_GE(std::sqrt(wall.distance2(at)), wall.radius + 0.002);
        EXPECT_GE(at.y, above + 0.002);
      }
  }
}

TEST(ObstaclePacking, DrumHoldsAllOrRefuses) {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  scene.bed.width = scene.bed.height = 0.1;
  scene.contacts.restitution = 0.5;
  scene.particles.count = 150;
  ObstacleSettings drum;
  drum.shape = ObstacleShape::drum;
  drum.x = drum.y = drum.radius = 0.05;
  scene.obstacles = {drum};
  const Result<Particles> start = packBed(scene);
  ASSERT_TRUE(start);
  for (const Vec2 at : start->position) EXPECT_LE(norm(at - Vec2{0.05, 0.05}), 0.0481);
  scene.particles.count = 600;
  EXPECT_FALSE(packBed(scene));
}

}  // namespace
}  // namespace bedmix
