// SPDX-License-Identifier: MIT
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

// One step of a stair, left to right as bedWalls() lays it: tread, riser, upper tread. The concave corner is
// at (10, 0) mm, the outer one at (10, 12) mm.
std::vector<WallSegment> stair(bool ownsA) {
  const Vec2 chain[] = {{0.0, 0.0}, {0.01, 0.0}, {0.01, 0.012}, {0.03, 0.012}};
  std::vector<WallSegment> walls;
  for (int c = 0; c < 3; ++c) walls.push_back({chain[c], chain[c + 1], ownsA, !ownsA});
  return walls;
}

/// Wall contacts and direction of the push on a sphere of 2 mm radius at `centre`, after a first short step.
struct Push {
  std::int64_t contacts;
  Vec2 velocity;  // m/s
};
Push pushAt(Vec2 centre, const std::vector<WallSegment>& walls) {
  Scene scene = smoothSpheres();
  scene.time.step = 1e-9;
  const auto solver = solverAt(scene, {centre}, walls);
  EXPECT_FALSE(solver->advance(1));
  return {solver->contactCount(), solver->particles().velocity[0]};
}

/// The speed one contact of this depth (m) gives in the one step.
double speedFrom(double depth) {
  const Scene scene = smoothSpheres();
  return normalStiffness(scene) * depth / particleMass(scene) * 1e-9;
}

class Corner : public testing::TestWithParam<bool> {
 protected:
  std::vector<WallSegment> walls_ = stair(GetParam());
};

TEST_P(Corner, OuterCornerPushesOnceFromAbove) {
  const Push push = pushAt({0.0103, 0.0139}, walls_);
  EXPECT_EQ(push.contacts, 1);
  EXPECT_NEAR(push.velocity.y, speedFrom(1e-4), 1e-4 * speedFrom(1e-4));
  EXPECT_DOUBLE_EQ(push.velocity.x, 0.0);
}

TEST_P(Corner, OuterCornerPushesOnceFromTheSide) {
  const Push push = pushAt({0.0081, 0.0117}, walls_);
  EXPECT_EQ(push.contacts, 1);
  EXPECT_NEAR(push.velocity.x, -speedFrom(1e-4), 1e-4 * speedFrom(1e-4));
  EXPECT_DOUBLE_EQ(push.velocity.y, 0.0);
}

TEST_P(Corner, OuterCornerPushesOnceAlongTheDiagonal) {
  const double depth = 1e-4, away = (0.002 - depth) / std::sqrt(2.0);
  const Push push = pushAt({0.01 - away, 0.012 + away}, walls_);
  EXPECT_EQ(push.contacts, 1);
  EXPECT_NEAR(push.velocity.x, -speedFrom(depth) / std::sqrt(2.0), 1e-4 * speedFrom(depth));
  EXPECT_NEAR(push.velocity.y, speedFrom(depth) / std::sqrt(2.0), 1e-4 * speedFrom(depth));
}

TEST_P(Corner, OuterCornerPushesOnceExactlyAboveAndBeside) {
  EXPECT_EQ(pushAt({0.01, 0.0139}, walls_).contacts, 1);
  EXPECT_EQ(pushAt({0.0081, 0.012}, walls_).contacts, 1);
}

TEST_P(Corner, ConcaveCornerPushesTwice) {
  const Push push = pushAt({0.0081, 0.0019}, walls_);
  EXPECT_EQ(push.contacts, 2);
  EXPECT_NEAR(push.velocity.x, -speedFrom(1e-4), 1e-4 * speedFrom(1e-4));
  EXPECT_NEAR(push.velocity.y, speedFrom(1e-4), 1e-4 * speedFrom(1e-4));
}

TEST_P(Corner, OutOfReachPushesNot) { EXPECT_EQ(pushAt({0.0085, 0.0141}, walls_).contacts, 0); }

// A frictionless sphere that passes over the corner keeps its energy only if it is never pushed twice.
TEST_P(Corner, SphereGlidesOverTheOuterCorner) {
  Scene scene = smoothSpheres();
  scene.contacts.restitution = 1.0;
  scene.gravity = 9.81;
  const auto solver = solverAt(scene, {{0.014, 0.01399}}, walls_);
  solver->particles().velocity[0].x = -0.03;
  const auto energy = [&] {
    return solver->kineticEnergy() + solver->elasticEnergy() + solver->potentialEnergy();
  };
  ASSERT_FALSE(solver->advance(0));
  const double start = energy();
  std::int64_t most = 0;
  while (solver->particles().position[0].y > 0.0115) {
    ASSERT_FALSE(solver->advance(1));
    most = std::max(most, solver->contactCount());
  }
  EXPECT_EQ(most, 1);
  EXPECT_NEAR(energy(), start, 1e-4 * start);
}

INSTANTIATE_TEST_SUITE_P(EndsOwned, Corner, testing::Bool(),
                         [](const auto& tried) { return tried.param ? "byTheNext" : "byTheFormer"; });

TEST(Walls, FreeEndPushes) {
  EXPECT_EQ(pushAt({-0.0019, 0.0}, {{{0.0, 0.0}, {0.01, 0.0}}}).contacts, 1);
  EXPECT_EQ(pushAt({-0.0019, 0.0}, {{{0.0, 0.0}, {0.01, 0.0}, false, true}}).contacts, 0);
}

TEST(Walls, AreTouchedFromEitherSide) {
  EXPECT_LT(pushAt({0.005, -0.0019}, {{{0.0, 0.0}, {0.01, 0.0}}}).velocity.y, 0.0);
  EXPECT_GT(pushAt({0.005, 0.0019}, {{{0.0, 0.0}, {0.01, 0.0}}}).velocity.y, 0.0);
}

}  // namespace
}  // namespace bedmix
