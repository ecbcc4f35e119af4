// SPDX-License-Identifier: MIT
#include "engine/core/rng.h"
#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bedmix {
namespace {

constexpr double span = 1e-4;
constexpr double side = 0.12;

/// What closingSpeed() promises, asked of all pairs and the four walls of the box.
double hardestImpact(const Scene& scene, const Particles& p) {
  const double d = scene.particles.diameter, k = normalStiffness(scene);
  double hardest = 0.0;
  const auto look = [&](double gap, double closing, double mass) {
    if (gap < 0.0)
      hardest = std::max(hardest, std::sqrt(closing * closing + k / mass * gap * gap));
    else if (gap < closing * span)
      hardest = std::max(hardest, closing);
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 apart = p.position[j] - p.position[i];
      look(norm(apart) - d, dot(p.velocity[i] - p.velocity[j], apart) / norm(apart), p.mass / 2.0);
    }
    const Vec2 at = p.position[i], v = p.velocity[i];
    look(at.x - d / 2.0, -v.x, p.mass);
    look(side - at.x - d / 2.0, v.x, p.mass);
    look(at.y - d / 2.0, -v.y, p.mass);
    look(side - at.y - d / 2.0, v.y, p.mass);
  }
  return hardest;
}

std::unique_ptr<ParticleSolver> crowd(const Scene& scene, double spacing, ThreadTeam& team = oneThread()) {
  std::vector<Vec2> places;
  const int across = static_cast<int>(side / spacing);
  for (int i = 0; i < across * across; ++i)
    places.push_back({(0.5 + i % across) * spacing, (0.5 + i / across) * spacing});
  auto solver = ParticleSolver::make(scene, makeParticles(scene, places), closedBox(side, side), team);
  Rng rng(3);
  for (Vec2& v : solver->particles().velocity) v = {rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)};
  return solver;
}

class ClosingSpeed : public testing::TestWithParam<Integrator> {
 protected:
  ClosingSpeed() { scene_.time.integrator = GetParam(); }
  Scene scene_ = smoothSpheres();
};

// Within what the law of the overlaps is rounded to; above it only where the list does not reach far enough.
TEST_P(ClosingSpeed, IsThatOfTheHardestImpact) {
  const auto solver = crowd(scene_, 1.06 * scene_.particles.diameter);
  int exact = 0;
  constexpr int times = 100;
  for (int k = 0; k < times; ++k) {
    ASSERT_FALSE(solver->advance(20));
    const double found = solver->closingSpeed(span), expected = hardestImpact(scene_, solver->particles());
    EXPECT_GE(found, 0.99 * expected);
    EXPECT_LE(found, 2.0 * solver->fastest().speed);
    exact += found <= 1.01 * expected;
  }
  EXPECT_GT(exact, times * 4 / 5);
}

TEST_P(ClosingSpeed, TellsOfWhoMeetsWithinTheSpanAlone) {
  const double d = scene_.particles.diameter;
  for (const auto& [gap, expected] : {std::pair{0.9 * span, 1.0}, std::pair{1.1 * span, 0.0}}) {
    const auto pair = solverAt(scene_, {{0.0, 0.0}, {d + gap, 0.0}});
    pair->particles().velocity[0].x = 1.0;
    ASSERT_FALSE(pair->advance(0));
    EXPECT_NEAR(pair->closingSpeed(span), expected, 1e-2);
    const auto atWall = solverAt(scene_, {{0.0, 0.5 * d + gap}}, wideFloor());
    atWall->particles().velocity[0].y = -1.0;
    ASSERT_FALSE(atWall->advance(0));
    EXPECT_NEAR(atWall->closingSpeed(span), expected, 1e-2);
  }
  EXPECT_EQ(solverAt(scene_, {})->closingSpeed(span), 0.0);
}

// A contact is told by the speed with which it began, as long as it lasts and has not cost much energy.
TEST_P(ClosingSpeed, OfAContactIsThatOfItsImpact) {
  scene_.contacts.restitution = 1.0;
  scene_.time.step = 1e-6;
  const auto pair = solverAt(scene_, {{0.0, 0.0}, {scene_.particles.diameter + 1e-6, 0.0}});
  pair->particles().velocity[0].x = 0.4;
  ASSERT_FALSE(pair->advance(10));
  ASSERT_EQ(pair->contactCount(), 1);
  for (int touching = 0; pair->contactCount() == 1; ++touching) {
    EXPECT_NEAR(pair->closingSpeed(span), 0.4, 0.01 * 0.4) << touching;
    ASSERT_FALSE(pair->advance(1));
  }
  EXPECT_EQ(pair->closingSpeed(span), 0.0);
}

TEST_P(ClosingSpeed, IsKnownBeforeTheFirstStep) {
  const auto waiting = crowd(scene_, 1.01 * scene_.particles.diameter);
  const double expected = hardestImpact(scene_, waiting->particles());
  ASSERT_GT(expected, 0.0);
  EXPECT_NEAR(waiting->closingSpeed(span), expected, 0.01 * expected);
}

TEST_P(ClosingSpeed, ThreadsAndAskingChangeNothing) {
  const auto alone = crowd(scene_, 1.01 * scene_.particles.diameter);
  ThreadTeam team(3);
  const auto asked = crowd(scene_, 1.01 * scene_.particles.diameter, team);
  for (int k = 0; k < 50; ++k) {
    ASSERT_FALSE(alone->advance(10));
    ASSERT_FALSE(asked->advance(10));
    const double speed = asked->closingSpeed(span);
    if (k % 10 == 0) {
      EXPECT_EQ(alone->closingSpeed(span), speed);
    }
    StateHash a, b;
    alone->hashInto(a);
    asked->hashInto(b);
    ASSERT_EQ(a.value(), b.value());
  }
}

// A solver that was loaded tells the same.
TEST_P(ClosingSpeed, IsKeptByACheckpoint) {
  const auto saved = crowd(scene_, 1.01 * scene_.particles.diameter);
  for (int k = 0; k < 20; ++k) {
    ASSERT_FALSE(saved->advance(7));
    StateWriter out(0);
    saved->save(out);
    const auto loaded = crowd(scene_, 1.01 * scene_.particles.diameter);
    const std::vector<std::byte> bytes = out.take();
    StateReader in(bytes);
    ASSERT_TRUE(loaded->load(in));
    EXPECT_EQ(loaded->closingSpeed(20.0 * span), saved->closingSpeed(20.0 * span));
    EXPECT_EQ(loaded->closingSpeed(span), saved->closingSpeed(span));
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, ClosingSpeed, eachIntegrator(), nameOfIntegrator);

}  // namespace
}  // namespace bedmix
