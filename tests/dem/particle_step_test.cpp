// SPDX-License-Identifier: MIT
#include "engine/dem/particle_step.h"

#include "engine/core/rng.h"
#include "engine/core/walls.h"
#include "engine/dem/packing.h"
#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bedmix {
namespace {

Scene automaticSpheres(Integrator integrator = Integrator::verletOnset) {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  scene.time.step = StepLength::automatic();
  scene.time.integrator = integrator;
  scene.limits.maxOverlap = 0.9;
  return scene;
}

/// The speed, m/s, at which two spheres part, or one and an upright wall, that met at `closing`; chosen anew
/// at moments that have nothing to do with their contact.
double partingSpeed(const Scene& scene, double closing, bool wall, Rng& rng) {
  const double d = scene.particles.diameter, gap = rng.uniform(0.0, 0.1) * d;
  std::vector<Vec2> places{{0.0, 0.0}};
  if (!wall) places.push_back({0.5 * d + gap + 0.5 * d, 0.0});
  const WallSegment upright{{0.5 * d + gap, -100.0}, {0.5 * d + gap, 100.0}, true, false};
  const auto solver = solverAt(scene, places, wall ? std::vector{upright} : std::vector<WallSegment>{});
  solver->particles().velocity[0].x = closing;
  ParticleStep steps(scene);
  const auto apart = [&] {
    const Particles p = inOrderOfIds(solver->particles());
    return wall ? Vec2{upright.a.x - p.position[0].x - 0.5 * d, p.velocity[0].x}
                : Vec2{p.position[1].x - p.position[0].x - d, p.velocity[0].x - p.velocity[1].x};
  };
  const auto moveOn = [&] { EXPECT_FALSE(steps.advance(0.3 * contactTimeScale(scene), *solver).trouble); };
  while (apart().x > 0.0 && apart().y > 0.5 * closing) moveOn();  // a contact may be over in one
  for (int glance = 0; glance < 8; ++glance) moveOn();            // several contacts long
  return -apart().y;
}

class ChosenSteps : public testing::TestWithParam<Integrator> {};

TEST_P(ChosenSteps, KeepTheErrorOfThePartingSpeed) {
  Rng rng(3);
  double largest = 0.0;  // of what is allowed
  for (const double e : {0.05, 0.9, 1.0})
    for (const auto& [closing, error] : {std::pair{0.01, 0.01}, {0.3, 0.01}, {3.0, 0.001}, {20.0, 0.1}})
      for (const bool wall : {false, true}) {
        Scene scene = automaticSpheres(GetParam());
        scene.contacts.restitution = e;
        scene.contacts.stiffness = closing > 10.0 ? 2e4 : 2e3;  // they do not pass through each other
        scene.time.error = error;
        const double allowed = error * std::sqrt(scene.gravity * scene.particles.diameter);
        const double missed = std::abs(partingSpeed(scene, closing, wall, rng) - e * closing);
        EXPECT_LE(missed, allowed) << e << ' ' << closing << " m/s, wall " << wall;
        largest = std::max(largest, missed / allowed);
      }
  EXPECT_GT(largest, 0.05);  // or they would be too short
}

INSTANTIATE_TEST_SUITE_P(Integrators, ChosenSteps,
                         testing::Values(Integrator::velocityVerlet, Integrator::rk4,
                                         Integrator::verletOnset),
                         nameOfIntegrator);

TEST(ParticleStep, FollowsTheHardestImpactThatComes) {
  Scene scene = automaticSpheres();
  scene.time.error = 1e-3;
  const double d = scene.particles.diameter, span = contactTimeScale(scene);
  const auto stepsAt = [&](double closing, double gap) {
    const auto solver = solverAt(scene, {{0.0, 0.0}, {d + gap, 0.0}});
    solver->particles().velocity[0].x = closing;
    return ParticleStep(scene).advance(span, *solver).steps;
  };
  EXPECT_EQ(stepsAt(0.0, 0.1 * d), 25);
  EXPECT_LT(stepsAt(0.3, 0.1 * d), stepsAt(1.0, 0.1 * d));
  EXPECT_LT(stepsAt(1.0, 0.1 * d), stepsAt(4.0, 0.1 * d));
  EXPECT_LT(stepsAt(0.7, 3.0 * d), stepsAt(0.7, 0.1 * d));  // too far apart to meet so soon
}

TEST(ParticleStep, WithoutGravityTheErrorIsOfTheImpact) {
  Scene scene = automaticSpheres();
  scene.gravity = 0.0;
  scene.time.error = 1e-3;
  Rng rng(5);
  for (const double closing : {1e-3, 1.0})
    EXPECT_NEAR(partingSpeed(scene, closing, false, rng), 0.9 * closing, 1e-3 * closing);
}

TEST(ParticleStep, LimitLetsDashpotsRest) {
  Scene scene = automaticSpheres();
  const double T = contactTimeScale(scene);
  EXPECT_DOUBLE_EQ(ParticleStep::limit(scene), T / 25.0);
  scene.time.error = 0.1;
  EXPECT_DOUBLE_EQ(ParticleStep::limit(scene), T / 14.0);
  scene.contacts.restitution = 0.05;
  EXPECT_DOUBLE_EQ(ParticleStep::limit(scene), 0.8 * particleMass(scene) / (6.0 * pairDamping(scene)));
}

/// A rough bed that has come to rest stays so; with steps of T/16 it hums at some 10 mm/s.
TEST(ParticleStep, PackedBedRests) {
  for (const double e : {0.9, 0.3, 0.1}) {
    Scene scene = automaticSpheres();
    scene.contacts.restitution = e;
    scene.contacts.friction = FrictionSettings{};
    scene.bed.width = 0.048;
    scene.particles.count = 240;
    const auto start = packBed(scene);
    ASSERT_TRUE(start);
    const auto solver = ParticleSolver::make(scene, *start, bedWalls(scene));
    ParticleStep steps(scene);
    for (int k = 0; k < 800; ++k) ASSERT_FALSE(steps.advance(contactTimeScale(scene), *solver).trouble);
    EXPECT_LT(solver->fastest().speed, 1e-4) << e;
  }
}

TEST(ParticleStep, TroubleTellsHowFarItCame) {
  Scene scene = automaticSpheres();
  scene.limits.maxOverlap = 0.01;
  const double d = scene.particles.diameter;
  const auto solver = solverAt(scene, {{0.0, 0.0}, {1.5 * d, 0.0}});
  solver->particles().velocity[0].x = 2.0;
  const ParticleStep::Outcome outcome = ParticleStep(scene).advance(1.0, *solver);
  ASSERT_TRUE(outcome.trouble);
  EXPECT_EQ(outcome.trouble->kind, DemTrouble::Kind::overlap);
  EXPECT_NEAR(outcome.seconds, 0.51 * d / 2.0, 0.01 * d / 2.0 + 2.0 * ParticleStep::limit(scene));
}

/// Six stiff spheres that fall 0.75 m, each to a floor of its own moment, bounce and come to rest.
struct HardImpacts {
  std::vector<Vec2> places;
  std::int64_t steps = 0;

  explicit HardImpacts(double step, double error = 0.0) {
    Scene scene = automaticSpheres();
    scene.contacts.restitution = 0.5;
    scene.contacts.stiffness = 2e4;
    std::vector<Vec2> start;
    for (int i = 0; i < 6; ++i) start.push_back({0.008 * i, 0.75 + 0.0031 * i});
    if (error == 0.0) {
      const std::int64_t each = std::llround(std::ceil(0.01 / step));
      scene.time.step = 0.01 / static_cast<double>(each);
      const auto solver = solverAt(scene, start, wideFloor());
      steps = 70 * each;
      EXPECT_FALSE(solver->advance(steps));
      places = inOrderOfIds(solver->particles()).position;
      return;
    }
    scene.time.error = error;
    const auto solver = solverAt(scene, start, wideFloor());
    ParticleStep chosen(scene);
    for (int k = 0; k < 70; ++k) steps += chosen.advance(0.01, *solver).steps;
    places = inOrderOfIds(solver->particles()).position;
  }
  double distance(const HardImpacts& other) const {
    double squares = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) squares += std::pow(places[i].y - other.places[i].y, 2.0);
    return std::sqrt(squares / static_cast<double>(places.size()));
  }
};

TEST(ParticleStep, BeatsEveryFixedStepOnHardImpacts) {
  Scene stiff = automaticSpheres();
  stiff.contacts.stiffness = 2e4;
  const double T = contactTimeScale(stiff);
  const HardImpacts exact(T / 1600.0);
  for (const double error : {0.01, 0.003}) {
    const HardImpacts chosen(0.0, error);
    for (double ofScale = 14.0; ofScale < 400.0; ofScale *= 1.1) {
      const HardImpacts fixed(T / ofScale);
      EXPECT_TRUE(fixed.steps > chosen.steps || fixed.distance(exact) > chosen.distance(exact))
          << "T/" << ofScale << ": " << fixed.steps << " steps, " << fixed.distance(exact)
          << " m off; chosen " << chosen.steps << ", " << chosen.distance(exact);
    }
  }
}

}  // namespace
}  // namespace bedmix
