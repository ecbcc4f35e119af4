// SPDX-License-Identifier: MIT
#include "engine/core/rng.h"
#include "engine/dem/contact_forces.h"
#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <compare>
#include <set>
#include <utility>
#include <vector>

namespace bedmix {
namespace {

constexpr double diameter = 0.004;
using Pairs = std::set<std::pair<int, int>>;

/// `count` points at random in a box, some of them far above it.
std::vector<Vec2> randomCloud(Rng& rng, int count, double width, double height) {
  std::vector<Vec2> cloud;
  for (int i = 0; i < count; ++i) {
    const double x = rng.uniform(0.0, width);
    cloud.push_back({x, rng.uniform() < 0.05 ? rng.uniform(0.0, 100.0 * height) : rng.uniform(0.0, height)});
  }
  return cloud;
}

Scene roughSpheres() {
  Scene scene = smoothSpheres();
  scene.contacts.friction = FrictionSettings{};
  return scene;
}

/// A bed of points with its list made.
BedState listed(const Scene& scene, const std::vector<Vec2>& cloud,
                const std::vector<WallSegment>& walls = {}) {
  BedState bed(scene, makeParticles(scene, cloud), walls, oneThread());
  ContactSlots spare;
  EXPECT_TRUE(bed.sort());
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b)
    bed.contacts.find(b, bed.contacts.innerSkin(0.0), bed.bodies, spare);
  bed.contacts.link();
  return bed;
}

/// Pairs of ids.
Pairs closerThan(const std::vector<Vec2>& cloud, double distance) {
  Pairs found;
  const auto n = static_cast<int>(cloud.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      if (norm(cloud[j] - cloud[i]) < distance) found.insert({i, j});
  return found;
}

void insert(Pairs& pairs, const BedState& bed, std::int32_t i, std::int32_t j) {
  const int a = bed.particles.id[i], b = bed.particles.id[j];
  EXPECT_TRUE(pairs.insert({std::min(a, b), std::max(a, b)}).second) << "twice";
}

Pairs candidates(const BedState& bed) {
  Pairs pairs;
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b) {
    const ContactBlock& block = bed.contacts.block(b);
    for (std::size_t k = 0; k < block.candidateCount; ++k)
      insert(pairs, bed, block.candidates[k].first, block.candidates[k].second);
    for (std::size_t c = 0; c < block.crossing.count; ++c)
      insert(pairs, bed, block.crossing.first[c], block.crossing.second[c]);
  }
  return pairs;
}

TEST(ContactList, CandidatesAreAllPairsWithinTheSkin) {
  Rng rng(7);
  for (int draw = 0; draw < 200; ++draw) {
    // The last ones are cut into several blocks.
    const int count = draw < 190 ? static_cast<int>(rng.uniform(0.0, 120.0)) : 4000;
    const double size = draw < 190 ? 0.1 : 0.3;
    const std::vector<Vec2> cloud = randomCloud(rng, count, rng.uniform(1e-3, size), rng.uniform(1e-3, size));
    const BedState bed = listed(roughSpheres(), cloud);
    const double reach = diameter + bed.contacts.fullBudget(0.0).outer;
    if (count == 4000) {
      EXPECT_GT(bed.contacts.blocks(), 2u);
    }
    EXPECT_EQ(candidates(bed), closerThan(cloud, reach)) << "draw " << draw;
  }
}

TEST(ContactList, NearOnesAreThoseWithinTheInnerSkinInAscendingOrder) {
  Rng rng(8);
  const std::vector<Vec2> cloud = randomCloud(rng, 2500, 0.2, 0.1);
  const BedState bed = listed(roughSpheres(), cloud);
  const double reach = diameter + bed.contacts.fullBudget(0.0).inner;
  Pairs near;
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b) {
    const ContactSlots& s = bed.contacts.block(b).near;
    for (std::size_t c = 0; c < s.count; ++c) {
      insert(near, bed, s.first[c], s.second[c]);
      if (c > 0) {
        EXPECT_LE(s.first[c - 1], s.first[c]);
      }
    }
    const ContactSlots& crossing = bed.contacts.block(b).crossing;
    for (std::size_t c = 0; c < crossing.count; ++c)
      if (norm(bed.bodies[crossing.first[c]].position - bed.bodies[crossing.second[c]].position) < reach)
        insert(near, bed, crossing.first[c], crossing.second[c]);
  }
  EXPECT_EQ(near, closerThan(cloud, reach));
}

TEST(ContactList, WallsWithinReachAreListed) {
  Rng rng(3);
  const std::vector<Vec2> cloud = randomCloud(rng, 300, 0.05, 0.05);
  const BedState bed = listed(roughSpheres(), cloud, closedBox(0.05, 0.05));
  const double reach = diameter / 2.0 + bed.contacts.fullBudget(0.0).outer;
  Pairs expected, found;
  for (int i = 0; i < 300; ++i) {
    const double x = cloud[i].x, y = cloud[i].y, above = std::max(y - 0.05, 0.0);
    const double distances[] = {y, std::hypot(0.05 - x, above), std::abs(0.05 - y), std::hypot(x, above)};
    for (int w = 0; w < 4; ++w)
      if (distances[w] < reach) expected.insert({i, w});
  }
  for (const ContactBlock::AtWall& w : bed.contacts.block(0).walls)
    for (std::size_t c = 0; c < w.slots.count; ++c)
      found.insert({bed.particles.id[w.slots.first[c]], static_cast<int>(w.wall)});
  EXPECT_EQ(found, expected);
}

TEST(ContactList, TwoMayEachMoveByHalfTheSkin) {
  const BedState bed = listed(roughSpheres(), {{0.0, 0.0}, {1.0, 0.0}});
  SkinBudget budget = bed.contacts.fullBudget(0.0);
  EXPECT_GT(budget.outer, budget.inner);
  const double half = 0.5 * budget.outer;
  budget.spend(0.9 * half);
  EXPECT_NEAR(budget.outer, 0.2 * half, 1e-12);
  EXPECT_LT(budget.inner, 0.0);
  const auto left = [&](Vec2 first, Vec2 second) {
    std::vector<Body> moved = bed.bodies;
    moved[0].position += first;
    moved[1].position += second;
    return bed.contacts.remainder(bed.contacts.displacements({0, 2}, moved));
  };
  EXPECT_NEAR(left({0.2 * half, 0.0}, {}), 1.8 * half, 1e-12);  // one has moved, by less
  EXPECT_NEAR(left({0.3 * half, 0.0}, {0.0, -0.4 * half}), 1.3 * half, 1e-12);
  EXPECT_LT(left({0.95 * half, 0.0}, {0.0, 0.95 * half}), 0.0);
}

/// Every slot with a history.
std::vector<std::tuple<int, int, double, double>> contactsOf(const BedState& bed) {
  std::vector<std::tuple<int, int, double, double>> all;
  const auto add = [&](const ContactSlots& s, auto&& other) {
    for (std::size_t c = 0; c < s.count; ++c) {
      const int a = bed.particles.id[s.first[c]], b = other(c);
      if (s.spring[c] != 0.0) all.emplace_back(std::max(a, b), std::min(a, b), s.spring[c], s.slip[c]);
    }
  };
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b) {
    const ContactBlock& block = bed.contacts.block(b);
    for (const ContactSlots* s : {&block.near, &block.crossing})
      add(*s, [&](std::size_t c) { return bed.particles.id[s->second[c]]; });
    for (const ContactBlock::AtWall& w : block.walls)
      add(w.slots, [&](std::size_t) { return -1 - static_cast<int>(w.wall); });
  }
  std::sort(all.begin(), all.end());
  return all;
}

// Contacts keep spring and slip to the bit while particles move across cells, strips and blocks.
TEST(ContactList, ANewListAndANewChoiceKeepEveryHistory) {
  Rng rng(5);
  const double width = 0.25;
  std::vector<Vec2> cloud = randomCloud(rng, 3000, width, 0.12);
  for (Vec2& at : cloud) at.y = std::min(at.y, 0.2);
  BedState bed = listed(roughSpheres(), cloud, closedBox(width, 0.3));
  const auto stretch = [&](ContactSlots& s) {
    for (std::size_t c = 0; c < s.count; ++c) s.spring[c] = rng.uniform(-1.0, 1.0), s.slip[c] = rng.uniform();
  };
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b) {
    stretch(bed.contacts.block(b).near);
    for (ContactBlock::AtWall& w : bed.contacts.block(b).walls) stretch(w.slots);
    // Only contacts have a history, and they are near.
    ContactSlots& s = bed.contacts.block(b).crossing;
    for (std::size_t c = 0; c < s.count; ++c)
      if (norm(bed.bodies[s.first[c]].position - bed.bodies[s.second[c]].position) < diameter)
        s.spring[c] = rng.uniform(-1.0, 1.0), s.slip[c] = rng.uniform();
  }
  const auto before = contactsOf(bed);
  ASSERT_GT(before.size(), 3000u);
  ContactSlots spare;
  for (int round = 0; round < 5; ++round) {
    // All move alike, so who touches stays; the box they lie in begins elsewhere, so they are sorted anew.
    for (Body& body : bed.bodies) body.position += {0.0003, 0.0};
    if (round % 2 == 0) bed.bodies[0].position += {-0.0011, 0.0};
    ASSERT_TRUE(bed.sort());
    for (std::size_t b = 0; b < bed.contacts.blocks(); ++b)
      bed.contacts.find(b, bed.contacts.innerSkin(0.0), bed.bodies, spare);
    bed.contacts.link();
    for (std::size_t b = 0; b < bed.contacts.blocks(); ++b)
      bed.contacts.refresh(b, bed.contacts.innerSkin(0.0), bed.bodies, spare);
    const auto after = contactsOf(bed);
    std::size_t same = 0;
    for (const auto& contact : after) same += std::binary_search(before.begin(), before.end(), contact);
    EXPECT_EQ(same, after.size());
    EXPECT_GT(same, before.size() * 9 / 10);  // some leave a wall or the one that was moved
  }
}

// Points that wander at random for thousands of steps: by the rules of the budget none may come to touch
// without being listed.
TEST(ContactList, WanderingPointsNeverTouchUnlisted) {
  Rng rng(11);
  BedState bed = listed(smoothSpheres(), randomCloud(rng, 60, 0.03, 0.03));
  ContactSlots spare;
  SkinBudget budget = bed.contacts.fullBudget(0.0);
  constexpr int steps = 5000;
  int choices = 0;
  for (int step = 0; step < steps; ++step) {
    const double stride = rng.uniform(0.0, 1e-4);
    for (Body& body : bed.bodies)
      body.position += {rng.uniform(-0.7, 0.7) * stride, rng.uniform(-0.7, 0.7) * stride};
    budget.spend(stride);
    if (budget.outer < 0.0) {
      budget.outer = bed.contacts.remainder(bed.contacts.displacements({0, 60}, bed.bodies));
      if (budget.outer < 0.0) {
        ASSERT_TRUE(bed.sort());
        bed.contacts.find(0, bed.contacts.innerSkin(0.0), bed.bodies, spare);
        bed.contacts.link();
        budget = bed.contacts.fullBudget(0.0);
      }
    }
    if (budget.inner < 0.0) {
      bed.contacts.refresh(0, bed.contacts.innerSkin(0.0), bed.bodies, spare);
      budget.inner = bed.contacts.fullBudget(0.0).inner;
      ++choices;
    }
    std::vector<Vec2> byId(60);
    for (int i = 0; i < 60; ++i) byId[bed.particles.id[i]] = bed.bodies[i].position;
    Pairs near;
    const ContactSlots& s = bed.contacts.block(0).near;
    for (std::size_t c = 0; c < s.count; ++c) insert(near, bed, s.first[c], s.second[c]);
    for (const auto& pair : closerThan(byId, diameter)) ASSERT_TRUE(near.contains(pair)) << "step " << step;
  }
  EXPECT_GT(bed.contacts.builds(), 10);
  EXPECT_LT(bed.contacts.builds(), steps / 20);
  EXPECT_GT(choices, 2 * bed.contacts.builds());
}

// The forces of one evaluation against the law written out for all pairs, springs and friction included.
TEST(ContactList, ForcesAreThoseOfAllPairs) {
  const Scene scene = roughSpheres();
  Rng rng(17);
  const std::vector<Vec2> cloud = randomCloud(rng, 3000, 0.1, 0.08);
  BedState bed = listed(scene, cloud);
  const std::size_t n = cloud.size();
  for (std::size_t i = 0; i < n; ++i) {
    bed.bodies[i].velocity = {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    bed.spinAhead[i] = rng.uniform(-100.0, 100.0);
  }
  struct Before {
    std::int32_t i, j;
    double spring;
    const double* after;
  };
  std::vector<Before> pairs;
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b)
    for (ContactSlots* s : {&bed.contacts.block(b).near, &bed.contacts.block(b).crossing})
      for (std::size_t c = 0; c < s->count; ++c) {
        s->spring[c] = rng.uniform(-1e-4, 1e-4);
        pairs.push_back({s->first[c], s->second[c], s->spring[c], &s->spring[c]});
      }
  const ContactForces forces(scene);
  const Motion at{bed.bodies.data(), bed.spinAhead.data()};
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b)
    forces.evaluate(bed, b, at, [](ContactSlots& s, std::size_t) { return inPlace(s); });
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b) ContactForces::addIncoming(bed, b);

  const SpringDashpot law = pairLaw(scene);
  std::vector<Load> loads(n);
  int sliding = 0, sticking = 0;
  for (const auto& [i, j, spring, after] : pairs) {
    const Vec2 apart = bed.bodies[j].position - bed.bodies[i].position;
    if (norm(apart) >= diameter) {
      EXPECT_EQ(*after, 0.0);
      continue;
    }
    const Vec2 normal = (1.0 / norm(apart)) * apart, tangent{-normal.y, normal.x};
    const Vec2 relative = bed.bodies[i].velocity - bed.bodies[j].velocity;
    const double push = law.stiffness * (diameter - norm(apart)) + law.damping * dot(relative, normal);
    const double slip = dot(relative, tangent) + 0.002 * (bed.spinAhead[i] + bed.spinAhead[j]);
    double along = -law.tangentialStiffness * spring - law.tangentialDamping * slip;
    const double limit = 0.3 * std::abs(push);
    if (std::abs(along) > limit) {
      along = std::copysign(limit, along);
      ++sliding;
    } else {
      ++sticking;
    }
    EXPECT_NEAR(-law.tangentialStiffness * *after - law.tangentialDamping * slip, along, 1e-12);
    const Vec2 force = -push * normal + along * tangent;
    loads[i] += {force, 0.002 * along};
    loads[j] += {-1.0 * force, 0.002 * along};
  }
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(bed.loads[i].force.x, loads[i].force.x, 1e-11);
    EXPECT_NEAR(bed.loads[i].force.y, loads[i].force.y, 1e-11);
    EXPECT_NEAR(bed.loads[i].torque, loads[i].torque, 1e-13);
  }
  EXPECT_GT(sliding, 100);
  EXPECT_GT(sticking, 100);
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
  for (Vec2& v : p.velocity) v = {rng.uniform(-2.0, 2.0), rng.uniform(-2.0, 2.0)};

  const double k = normalStiffness(scene), r = diameter / 2.0;
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
      const Vec2 at = p.position[i];
      for (std::size_t j = i + 1; j < p.size(); ++j) add(diameter - norm(p.position[j] - at));
      for (const double distance : {at.x, 0.03 - at.x, at.y, 0.06 - at.y}) add(r - distance);
    }
    ASSERT_NEAR(solver->elasticEnergy(), energy, 1e-9 * energy + 1e-18) << "step " << step;
    if (integrator != Integrator::rk4) {  // which counts those of its last stage
      ASSERT_EQ(solver->contactCount(), contacts) << "step " << step;
    }
    met += contacts;
  }
  EXPECT_GT(met, 6000);
  EXPECT_GT(solver->neighbourBuilds(), 40);
  EXPECT_LT(solver->neighbourBuilds(), 600);
}

TEST(ContactList, SolverMissesNoContact) {
  for (const Integrator integrator : allIntegrators()) {
    SCOPED_TRACE(modelName(integrator));
    expectNoContactMissed(integrator);
  }
}

// A sphere that leaves the bed for good must not make lists costly or wrong.
TEST(ContactList, FarFlyerIsHarmless) {
  const Scene scene = smoothSpheres();
  const auto solver = solverAt(scene, {{0.01, 0.01}, {0.0139, 0.01}, {0.03, 1000.0}});
  solver->particles().velocity[2].y = 190.0;
  ASSERT_FALSE(solver->advance(10));
  EXPECT_EQ(solver->contactCount(), 1);
}

}  // namespace
}  // namespace bedmix
