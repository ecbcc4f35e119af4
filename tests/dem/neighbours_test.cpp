// SPDX-License-Identifier: MIT
#include "engine/core/rng.h"
#include "engine/dem/contacts.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace bedmix {
namespace {

constexpr double diameter = 0.004;

struct Cloud {
  std::vector<double> x, y;
};

/// `count` points at random in a box, some of them far above it.
Cloud randomCloud(Rng& rng, int count, double width, double height) {
  Cloud cloud;
  for (int i = 0; i < count; ++i) {
    cloud.x.push_back(rng.uniform(0.0, width));
    cloud.y.push_back(rng.uniform() < 0.05 ? rng.uniform(0.0, 100.0 * height) : rng.uniform(0.0, height));
  }
  return cloud;
}

std::vector<Candidate> closerThan(const Cloud& cloud, double distance) {
  std::vector<Candidate> found;
  const auto n = static_cast<std::int32_t>(cloud.x.size());
  for (std::int32_t i = 0; i < n; ++i)
    for (std::int32_t j = i + 1; j < n; ++j)
      if (std::hypot(cloud.x[j] - cloud.x[i], cloud.y[j] - cloud.y[i]) < distance) found.push_back({i, j});
  return found;
}

TEST(Neighbours, ListIsThatOfAllPairsInAscendingOrder) {
  Rng rng(7);
  for (int draw = 0; draw < 200; ++draw) {
    const Cloud cloud = randomCloud(rng, static_cast<int>(rng.uniform(0.0, 120.0)), rng.uniform(1e-3, 0.1),
                                    rng.uniform(1e-3, 0.1));
    NeighbourList list(diameter, {});
    list.build(cloud.x, cloud.y);
    EXPECT_EQ(list.pairs(), closerThan(cloud, 1.3 * diameter)) << "draw " << draw;
  }
}

TEST(Neighbours, WallsWithinReachAreListed) {
  Rng rng(3);
  const Cloud cloud = randomCloud(rng, 300, 0.05, 0.05);
  NeighbourList list(diameter, closedBox(0.05, 0.05));
  list.build(cloud.x, cloud.y);
  std::vector<Candidate> expected;
  for (std::int32_t i = 0; i < 300; ++i) {
    const double x = cloud.x[i], y = cloud.y[i], above = std::max(y - 0.05, 0.0);
    const double distances[] = {y, std::hypot(0.05 - x, above), std::abs(0.05 - y), std::hypot(x, above)};
    for (std::int32_t w = 0; w < 4; ++w)
      if (distances[w] < 0.8 * diameter) expected.push_back({i, w});
  }
  EXPECT_EQ(list.wallPairs(), expected);
}

TEST(Neighbours, TwoMayEachMoveByHalfTheSkin) {
  NeighbourList list(diameter, {});
  list.build({0.0, 1.0}, {0.0, 0.0});
  const double half = 0.15 * diameter;
  EXPECT_TRUE(list.covers(0.99 * half));
  EXPECT_FALSE(list.covers(1.01 * half));
  EXPECT_TRUE(list.spend(0.5 * half));
  EXPECT_FALSE(list.covers(0.51 * half));
  EXPECT_FALSE(list.spend(0.51 * half));
  EXPECT_TRUE(list.measure({0.2 * half, 1.0}, {0.0, 0.0}));  // one has moved, by less
  EXPECT_TRUE(list.covers(0.89 * half));
  EXPECT_FALSE(list.covers(0.91 * half));
  EXPECT_FALSE(list.measure({0.95 * half, 1.0}, {0.0, -0.95 * half}));
}

// Points that wander at random for thousands of steps: by the rules of spend(), measure() and build() none
// may come to touch without being listed.
TEST(Neighbours, WanderingPointsNeverTouchUnlisted) {
  Rng rng(11);
  Cloud cloud = randomCloud(rng, 60, 0.03, 0.03);
  NeighbourList list(diameter, {});
  list.build(cloud.x, cloud.y);
  constexpr int steps = 5000;
  for (int step = 0; step < steps; ++step) {
    const double stride = rng.uniform(0.0, 1e-4);
    for (std::size_t i = 0; i < cloud.x.size(); ++i) {
      cloud.x[i] += rng.uniform(-0.7, 0.7) * stride;
      cloud.y[i] += rng.uniform(-0.7, 0.7) * stride;
    }
    if (!list.spend(stride) && !list.measure(cloud.x, cloud.y)) list.build(cloud.x, cloud.y);
    for (const Candidate& pair : closerThan(cloud, diameter))
      ASSERT_TRUE(std::binary_search(list.pairs().begin(), list.pairs().end(), pair)) << "step " << step;
  }
  EXPECT_GT(list.builds(), 10);
  EXPECT_LT(list.builds(), steps / 20);
}

// The solver's contacts and spring energy against all pairs, at every step of a crowd in a box.
void expectNoContactMissed(Integrator integrator) {
  Scene scene = smoothSpheres();
  scene.time.integrator = integrator;
  scene.gravity = 9.81;
  scene.limits.maxOverlap = 0.4;
  std::vector<Vec2> positions;
  for (int i = 0; i < 60; ++i) positions.push_back({0.005 * (0.5 + i % 6), 0.005 * (0.5 + i / 6)});
  const auto solver = solverAt(scene, positions, closedBox(0.03, 0.06));
  Particles& p = solver->particles();
  Rng rng(5);
  for (int i = 0; i < 60; ++i) p.vx[i] = rng.uniform(-2.0, 2.0), p.vy[i] = rng.uniform(-2.0, 2.0);

  const double k = scene.contacts.stiffness, r = diameter / 2.0;
  std::int64_t met = 0;
  for (int step = 0; step < 6000; ++step) {
    ASSERT_FALSE(solver->advance(1));
    std::int64_t contacts = 0;
    double energy = 0.0;
    const auto add = [&](double overlap) {
      if (overlap <= 0.0) return;
      ++contacts;
      energy += 0.5 * k * overlap * overlap;
    };
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (std::size_t j = i + 1; j < p.size(); ++j)
        add(diameter - std::hypot(p.x[j] - p.x[i], p.y[j] - p.y[i]));
      for (const double distance : {p.x[i], 0.03 - p.x[i], p.y[i], 0.06 - p.y[i]}) add(r - distance);
    }
    ASSERT_NEAR(solver->elasticEnergy(), energy, 1e-9 * energy + 1e-18) << "step " << step;
    if (integrator == Integrator::velocityVerlet) {
      ASSERT_EQ(solver->contactCount(), contacts) << "step " << step;
    }
    met += contacts;
  }
  EXPECT_GT(met, 6000);
  EXPECT_GT(solver->neighbourBuilds(), 50);
  EXPECT_LT(solver->neighbourBuilds(), 600);
}

TEST(Neighbours, SolverMissesNoContactWithVelocityVerlet) {
  expectNoContactMissed(Integrator::velocityVerlet);
}
TEST(Neighbours, SolverMissesNoContactWithRungeKutta4) { expectNoContactMissed(Integrator::rk4); }

// A sphere that leaves the bed for good must not make lists costly or wrong.
TEST(Neighbours, FarFlyerIsHarmless) {
  const Scene scene = smoothSpheres();
  const auto solver = solverAt(scene, {{0.01, 0.01}, {0.0139, 0.01}, {0.03, 0.01}});
  solver->particles().vy[2] = 1000.0;
  ASSERT_FALSE(solver->advance(10));
  EXPECT_EQ(solver->contactCount(), 1);
}

// The forces of one evaluation against the law written out for all pairs, springs and friction included.
TEST(Neighbours, ForcesAreThoseOfAllPairs) {
  Scene scene = smoothSpheres();
  scene.contacts.friction = FrictionSettings{};
  Rng rng(17);
  const Cloud cloud = randomCloud(rng, 150, 0.02, 0.02);
  std::vector<double> vx, vy, spin;
  for (int i = 0; i < 150; ++i) {
    vx.push_back(rng.uniform(-1.0, 1.0));
    vy.push_back(rng.uniform(-1.0, 1.0));
    spin.push_back(rng.uniform(-100.0, 100.0));
  }
  NeighbourList list(diameter, {});
  list.build(cloud.x, cloud.y);
  ContactHistory from, to;
  from.reset(list.size(), true);
  to.reset(list.size(), true);
  for (double& spring : from.spring) spring = rng.uniform(-1e-4, 1e-4);
  const std::size_t n = cloud.x.size();
  ContactLoads loads{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n), {}};
  ContactForces<true> forces(scene);
  forces.evaluate({cloud.x.data(), cloud.y.data(), vx.data(), vy.data(), spin.data()}, list, from, 0.0, to,
                  loads);

  const SpringDashpot law = pairLaw(scene);
  std::vector<double> fx(n), fy(n), torque(n);
  int sliding = 0, sticking = 0;
  for (std::size_t k = 0; k < list.pairs().size(); ++k) {
    const auto [i, j] = list.pairs()[k];
    const Vec2 apart{cloud.x[j] - cloud.x[i], cloud.y[j] - cloud.y[i]};
    if (norm(apart) >= diameter) {
      EXPECT_EQ(to.spring[k], 0.0);
      continue;
    }
    const Vec2 normal = (1.0 / norm(apart)) * apart, tangent{-normal.y, normal.x};
    const Vec2 relative{vx[i] - vx[j], vy[i] - vy[j]};
    const double push = law.stiffness * (diameter - norm(apart)) + law.damping * dot(relative, normal);
    const double slip = dot(relative, tangent) + 0.002 * (spin[i] + spin[j]);
    double along = -law.tangentialStiffness * from.spring[k] - law.tangentialDamping * slip;
    const double limit = 0.3 * std::abs(push);
    if (std::abs(along) > limit) {
      along = std::copysign(limit, along);
      ++sliding;
    } else {
      ++sticking;
    }
    EXPECT_NEAR(-law.tangentialStiffness * to.spring[k] - law.tangentialDamping * slip, along, 1e-12);
    const Vec2 force = -push * normal + along * tangent;
    fx[i] += force.x, fy[i] += force.y, fx[j] -= force.x, fy[j] -= force.y;
    torque[i] += 0.002 * along, torque[j] += 0.002 * along;
  }
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(loads.fx[i], fx[i], 1e-12);
    EXPECT_NEAR(loads.fy[i], fy[i], 1e-12);
    EXPECT_NEAR(loads.torque[i], torque[i], 1e-14);
  }
  EXPECT_GT(sliding, 10);
  EXPECT_GT(sticking, 10);
}

}  // namespace
}  // namespace bedmix
