// SPDX-License-Identifier: MIT
#include "engine/dem/packing.h"

#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bedmix {
namespace {

Scene paperBed(std::int64_t count, Arrangement arrangement) {
  Scene scene;
  scene.contacts.restitution = 0.9;
  scene.contacts.friction = FrictionSettings{};
  scene.particles.count = count;
  scene.start.arrangement = arrangement;
  return scene;
}

/// Deepest overlap of a bed with itself and its walls, m; negative where nothing touches.
double deepestOverlap(const Scene& scene, const Particles& p) {
  double deepest = -1.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = i + 1; j < p.size(); ++j)
      deepest = std::max(deepest, 2.0 * p.radius - norm(p.position[j] - p.position[i]));
    for (const WallShape& wall : wallShapes(bedWalls(scene)))
      deepest = std::max(deepest, p.radius - std::sqrt(wall.distance2(p.position[i])));
  }
  return deepest;
}

void expectInside(const Scene& scene, const Particles& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_GT(p.position[i].x, 0.0);
    EXPECT_LT(p.position[i].x, scene.bed.width);
    EXPECT_GT(p.position[i].y, floorHeight(scene, p.position[i].x));
  }
}

std::vector<double> heights(const Particles& p) {
  std::vector<double> sorted;
  for (const Vec2 at : p.position) sorted.push_back(at.y);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

double topHeight(const Particles& p) { return heights(p).back() + p.radius; }

TEST(Packing, DropTouchesNothing) {
  for (const std::int64_t count : {0, 1, 2, 999}) {
    for (const double slope : {0.0, 18.0}) {
      Scene scene = paperBed(count, Arrangement::drop);
      scene.floor.inclinationDeg = slope;
      const auto p = packBed(scene);
      ASSERT_TRUE(p);
      ASSERT_EQ(p->size(), static_cast<std::size_t>(count));
      EXPECT_LT(deepestOverlap(scene, *p), 0.0);
      expectInside(scene, *p);
      EXPECT_EQ(p->velocity, std::vector<Vec2>(p->size()));
    }
  }
}

TEST(Packing, SeedsGiveDifferentBedsAndTheSameSeedTheSame) {
  Scene scene = paperBed(40, Arrangement::settled);
  scene.bed.width = 0.03;
  const auto one = packBed(scene), same = packBed(scene);
  scene.time.integrator = Integrator::rk4;
  const auto forRungeKutta = packBed(scene);
  scene.seed = 2;
  const auto other = packBed(scene);
  ASSERT_TRUE(one && same && forRungeKutta && other);
  EXPECT_EQ(one->position, forRungeKutta->position);
  EXPECT_EQ(one->position, same->position);
  EXPECT_NE(one->position, other->position);
}

TEST(Packing, FewSettleOnTheFloor) {
  for (const std::int64_t count : {0, 1, 2}) {
    const Scene scene = paperBed(count, Arrangement::settled);
    const auto p = packBed(scene);
    ASSERT_TRUE(p);
    ASSERT_EQ(p->size(), static_cast<std::size_t>(count));
    const double sag = particleMass(scene) * scene.gravity / normalStiffness(scene);
    if (count == 1) {
      EXPECT_NEAR(p->position[0].y, p->radius - sag, 1e-8);
    }
  }
}

TEST(Packing, FloorIsInclinedOrAStair) {
  Scene scene = paperBed(60, Arrangement::settled);
  scene.bed.width = 0.048;
  scene.floor.inclinationDeg = 18.0;
  scene.gas = GasSettings{};
  scene.gas->grid = {.columns = {{4, 0.012}}, .rows = {{35, 0.012}}};
  for (const FloorShape shape : {FloorShape::straight, FloorShape::stair}) {
    scene.floor.shape = shape;
    const auto p = packBed(scene);
    ASSERT_TRUE(p);
    EXPECT_LT(deepestOverlap(scene, *p), 0.01 * scene.particles.diameter);
    EXPECT_GT(deepestOverlap(scene, *p), 0.0);
    EXPECT_LT(topHeight(*p), 0.06);

    // It is at rest: left alone, nothing moves but by what the springs give as they load.
    const auto solver = ParticleSolver::make(scene, *p, bedWalls(scene));
    ASSERT_FALSE(solver->advance(20000));
    const Particles later = inOrderOfIds(solver->particles());
    for (std::size_t i = 0; i < p->size(); ++i) {
      EXPECT_NEAR(later.position[i].x, p->position[i].x, 0.05 * scene.particles.diameter);
      EXPECT_NEAR(later.position[i].y, p->position[i].y, 0.05 * scene.particles.diameter);
    }
  }
}

TEST(Packing, ALidLeavesRoomOrSaysSo) {
  Scene scene = paperBed(200, Arrangement::drop);
  scene.bed.top = BedTop::lid;
  scene.bed.height = 0.045;  // 24 x 11 diameters
  const auto fits = packBed(scene);
  ASSERT_TRUE(fits);
  EXPECT_LT(deepestOverlap(scene, *fits), 0.0);
  EXPECT_LT(topHeight(*fits), 0.045);
  scene.particles.count = 300;
  const auto full = packBed(scene);
  ASSERT_FALSE(full);
  EXPECT_NE(full.problems.front().message.find("do not fit"), std::string::npos);
}

TEST(Packing, ABedNarrowerThanASphereIsRefused) {
  Scene scene = paperBed(1, Arrangement::drop);
  scene.bed.width = 0.0039;
  EXPECT_FALSE(packBed(scene));
}

// 1000 of the paper's spheres settle to 157 to 160 mm.
TEST(Packing, PapersBedSettlesToItsHeight) {
  const Scene scene = paperBed(1000, Arrangement::settled);
  const auto p = packBed(scene);
  ASSERT_TRUE(p);
  expectInside(scene, *p);
  const double level = heights(*p)[990] + p->radius;
  EXPECT_GT(level, 0.155);
  EXPECT_LT(level, 0.162);
  // At rest the most loaded contact bears some times what a sphere on the floor bears on average.
  const double share = 1000.0 / 24.0 * particleMass(scene) * scene.gravity / normalStiffness(scene);
  EXPECT_GT(deepestOverlap(scene, *p), share);
  EXPECT_LT(deepestOverlap(scene, *p), 6.0 * share);
}

}  // namespace
}  // namespace bedmix
