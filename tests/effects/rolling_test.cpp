// SPDX-License-Identifier: MIT
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bedmix {
namespace {

constexpr double g = 9.81, coefficient = 0.1;

Scene rollingScene(RollingModel model) {
  Scene scene = smoothSpheres();
  scene.gravity = g;
  scene.contacts.restitution = 0.5;
  scene.contacts.friction = FrictionSettings{.coefficient = 0.5};
  scene.contacts.rolling = RollingSettings{model, coefficient, 0.3};
  return scene;
}

class Rolling : public testing::TestWithParam<RollingModel> {};

/// A sphere that rolls without sliding slows down by 5/7 mu_r g: torque mu_r R m g against 7/5 m R^2.
TEST_P(Rolling, SphereOnAFloorSlowsDown) {
  const Scene scene = rollingScene(GetParam());
  const double r = 0.002, sag = particleMass(scene) * g / normalStiffness(scene), speed = 0.3;
  const auto solver = solverAt(scene, {{0.0, r - sag}}, wideFloor());
  Particles& p = solver->particles();
  p.velocity[0].x = speed;
  p.spin[0] = -speed / r;
  ASSERT_FALSE(solver->advance(20000));
  const double slower = 5.0 / 7.0 * coefficient * g * 0.2;
  EXPECT_NEAR((speed - p.velocity[0].x) / slower, 1.0, 0.01);
  EXPECT_NEAR(p.spin[0] * r, -p.velocity[0].x, 2e-3 * speed);
  // It stops after v^2/(2 a), and stays.
  ASSERT_FALSE(solver->advance(60000));
  const double way = speed * speed / (2.0 * 5.0 / 7.0 * coefficient * g);
  EXPECT_NEAR(p.position[0].x / way, 1.0, 0.01);
  EXPECT_LT(std::abs(p.velocity[0].x), 2e-3);
}

/// It stays on slopes of up to arctan mu_r, and rolls down steeper ones with g (sin - mu_r cos)/(7/5).
TEST_P(Rolling, SphereOnASlope) {
  const Scene scene = rollingScene(GetParam());
  const double r = 0.002, time = 0.2;
  for (const double share : {0.7, 2.0}) {
    const double slope = std::atan(share * coefficient);
    const Vec2 along{std::cos(slope), std::sin(slope)}, up{-std::sin(slope), std::cos(slope)};
    const double sag = particleMass(scene) * g * std::cos(slope) / normalStiffness(scene);
    const auto solver = solverAt(scene, {(r - sag) * up}, {{-10.0 * along, 10.0 * along}});
    ASSERT_FALSE(solver->advance(std::llround(time / scene.time.step)));
    const double way = -dot(solver->particles().position[0], along);
    const double rate = g * (std::sin(slope) - coefficient * std::cos(slope)) * 5.0 / 7.0;
    if (share < 1.0)
      EXPECT_LT(std::abs(way), 1e-4);
    else
      EXPECT_NEAR(way / (0.5 * rate * time * time), 1.0, 0.03);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Rolling,
                         testing::Values(RollingModel::elasticPlastic, RollingModel::constantTorque),
                         [](const auto& tried) {
                           return tried.param == RollingModel::elasticPlastic ? "ElasticPlastic"
                                                                              : "ConstantTorque";
                         });

/// Ai et al. (2011), their first test: type C comes to rest, type A goes on to and fro.
TEST(RollingModels, OnlyTheElasticPlasticComesToRest) {
  double left[2];
  for (const RollingModel model : {RollingModel::elasticPlastic, RollingModel::constantTorque}) {
    const Scene scene = rollingScene(model);
    const double r = 0.002, sag = particleMass(scene) * g / normalStiffness(scene);
    const auto solver = solverAt(scene, {{0.0, r - sag}}, wideFloor());
    Particles& p = solver->particles();
    p.velocity[0].x = 0.05;
    p.spin[0] = -0.05 / r;
    ASSERT_FALSE(solver->advance(100000));
    left[static_cast<int>(model)] = std::abs(p.spin[0]);
  }
  EXPECT_LT(left[0], 1e-6);
  EXPECT_GT(left[1], 1e-4);
}

/// The torques on two spheres that roll on each other are opposite: spin is not lost but against a wall.
TEST(RollingModels, KeepAngularMomentumOfPairs) {
  Scene scene = rollingScene(RollingModel::elasticPlastic);
  scene.gravity = 0.0;
  scene.contacts.friction->coefficient = 0.0;
  const double d = scene.particles.diameter;
  const auto solver = solverAt(scene, {{0.0, 0.0}, {0.99 * d, 0.0}});
  Particles& p = solver->particles();
  p.addExternalForces();
  p.external = {{0.2, 0.0}, {-0.2, 0.0}};
  p.spin = {20.0, 5.0};
  ASSERT_FALSE(solver->advance(500));
  EXPECT_LT(p.spin[0], 19.0);
  EXPECT_NEAR(p.spin[0] + p.spin[1], 25.0, 1e-9);
}

}  // namespace
}  // namespace bedmix
