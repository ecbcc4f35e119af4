// SPDX-License-Identifier: MIT
#include "engine/effects/cohesion.h"

#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

using std::numbers::pi;
constexpr double r = 0.002;  // m

Scene elastic(const CohesionSettings& cohesion) {
  Scene scene = smoothSpheres();
  scene.contacts.restitution = 1.0;
  scene.effects.at<CohesionSettings>() = cohesion;
  scene.time.step = 1e-6;
  return scene;
}

/// What pulls a sphere at rest towards another, or towards a floor, across a gap (m), N.
double pullAcross(Scene scene, double gap, bool atFloor) {
  scene.time.step = 1e-8;  // within which nothing moves
  const auto solver = atFloor ? solverAt(scene, {{0.0, r + gap}}, wideFloor())
                              : solverAt(scene, {{0.0, 2.0 * r + gap}, {0.0, 0.0}});
  EXPECT_FALSE(solver->advance(1));
  return -solver->particles().velocity[0].y * particleMass(scene) / scene.time.step;
}

TEST(Cohesion, VanDerWaalsIsHamakers) {
  CohesionSettings cohesion;
  cohesion.vanDerWaals = VanDerWaalsSettings{.hamaker = 1e-12, .leastGap = 1e-6, .cutoff = 5e-5};
  const Scene scene = elastic(cohesion);
  for (const double gap : {2e-6, 1e-5, 4.9e-5}) {
    EXPECT_NEAR(pullAcross(scene, gap, false) / (1e-12 * (r / 2.0) / (6.0 * gap * gap)), 1.0, 1e-6);
    EXPECT_NEAR(pullAcross(scene, gap, true) / (1e-12 * r / (6.0 * gap * gap)), 1.0, 1e-6);
  }
  EXPECT_EQ(pullAcross(scene, 5.1e-5, false), 0.0);
  // In touch it is that of the least gap, less the spring.
  const double least = 1e-12 * (r / 2.0) / (6.0 * 1e-12), overlap = 1e-8;
  EXPECT_NEAR((pullAcross(scene, -overlap, false) + normalStiffness(scene) * overlap) / least, 1.0, 1e-6);
  EXPECT_NEAR(pullAtTouch(scene), least, 1e-12);
}

CohesionSettings wet() {
  CohesionSettings cohesion;
  cohesion.liquidBridge =
      LiquidBridgeSettings{.surfaceTension = 0.072, .volume = 1e-3, .contactAngleDeg = 20.0};
  return cohesion;
}

/// Mikami et al. (1998), written out again: A, B, C of Eqs (15) to (17) and the rupture of Eq. (18).
double bridgeForce(double gap) {
  const double v = 1e-3, theta = 20.0 * pi / 180.0, logV = std::log(v), h = gap / r;
  const double a = -1.1 * std::pow(v, -0.53);
  const double b = (-0.034 * logV - 0.96) * theta * theta - 0.019 * logV + 0.48;
  const double c = 0.0042 * logV + 0.078;
  return pi * r * 0.072 * (std::exp(a * h + b) + c);
}
double rupture() { return r * (0.62 * 20.0 * pi / 180.0 + 0.99) * std::pow(1e-3, 0.34); }

/// A bridge that has formed takes the work of its force up to where it breaks from whoever leaves.
TEST(Cohesion, BridgeTakesItsWorkFromWhoLeaves) {
  const Scene scene = elastic(wet());
  const auto solver = solverAt(scene, {{0.0, 2.0 * r - 1e-9}, {0.0, 0.0}});
  Particles& p = solver->particles();
  const double speed = 0.3;
  p.velocity[0].y = 0.5 * speed;
  p.velocity[1].y = -0.5 * speed;
  double work = 0.0;
  constexpr int parts = 10000;
  for (int k = 0; k < parts; ++k) work += bridgeForce((k + 0.5) / parts * rupture()) * rupture() / parts;
  ASSERT_FALSE(solver->advance(3000));
  const Particles after = inOrderOfIds(p);
  const double left = after.velocity[0].y - after.velocity[1].y;
  const double reduced = 0.5 * particleMass(scene);
  ASSERT_GT(after.position[0].y - after.position[1].y, 2.0 * r + rupture());
  EXPECT_NEAR(0.5 * reduced * (speed * speed - left * left) / work, 1.0, 0.01);
}

/// The regression against what it is a regression of: two spheres in touch, their bridge from Young's and
/// Laplace's equation, integrated from the neck to where it meets the sphere at the contact angle. Forces
/// over pi R gamma.
TEST(Cohesion, BridgesHoldAsYoungAndLaplaceSay) {
  struct Exact {
    double volume, angle, force, within;
  };
  for (const Exact& exact : {Exact{1e-3, 0.0, 1.872, 0.05},
                             {1e-3, 20.0, 1.745, 0.05},
                             {1e-3, 40.0, 1.388, 0.05},
                             {1e-3, 60.0, 0.845, 0.05},
                             {1e-2, 0.0, 1.769, 0.05},
                             {1e-2, 20.0, 1.638, 0.05},
                             {1e-2, 40.0, 1.272, 0.05},
                             {1e-2, 60.0, 0.724, 0.1}}) {
    CohesionSettings cohesion;
    cohesion.liquidBridge = LiquidBridgeSettings{0.072, exact.volume, exact.angle};
    EXPECT_NEAR(pullAtTouch(elastic(cohesion)) / (pi * r * 0.072 * exact.force), 1.0, exact.within)
        << exact.volume << ' ' << exact.angle;
  }
}

TEST(Cohesion, BridgesFormOnTouchAlone) {
  const Scene scene = elastic(wet());
  EXPECT_EQ(pullAcross(scene, 0.2 * rupture(), false), 0.0);
  EXPECT_NEAR(pullAcross(scene, -1e-10, false) / bridgeForce(0.0), 1.0, 1e-3);
  EXPECT_NEAR(pullAtTouch(scene) / bridgeForce(0.0), 1.0, 1e-9);
}

/// Slower than what it takes to break the bridge they do not part.
TEST(Cohesion, SlowOnesStayTogether) {
  const Scene scene = elastic(wet());
  const auto solver = solverAt(scene, {{0.0, 2.0 * r - 1e-9}, {0.0, 0.0}});
  solver->particles().velocity = {{0.0, 0.02}, {0.0, -0.02}};
  ASSERT_FALSE(solver->advance(100000));
  const Particles after = inOrderOfIds(solver->particles());
  EXPECT_LT(after.position[0].y - after.position[1].y, 2.0 * r + rupture());
}

/// Energy density times the area of the circle in which the spheres cut each other, or one and a wall.
TEST(Cohesion, SjkrIsByTheAreaOfContact) {
  CohesionSettings cohesion;
  cohesion.sjkr = SjkrSettings{2e5};
  const Scene scene = elastic(cohesion);
  const double overlap = 2e-5, k = normalStiffness(scene);
  const double half = r - overlap / 2.0, pair = pi * (r * r - half * half);
  const double wall = pi * (r * r - (r - overlap) * (r - overlap));
  EXPECT_NEAR((pullAcross(scene, -overlap, false) + k * overlap) / (2e5 * pair), 1.0, 1e-5);
  EXPECT_NEAR((pullAcross(scene, -overlap, true) + k * overlap) / (2e5 * wall), 1.0, 1e-5);
  EXPECT_EQ(pullAcross(scene, 1e-9, false), 0.0);
}

}  // namespace
}  // namespace bedmix
