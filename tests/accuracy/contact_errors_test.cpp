// SPDX-License-Identifier: MIT
#include "app/accuracy/contact_errors.h"

#include "app/accuracy/damped_contact.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

Scene spheres(Integrator integrator, double step) {
  Scene scene;
  scene.contacts.restitution = 0.9;
  scene.contacts.friction = FrictionSettings{};
  scene.time.integrator = integrator;
  scene.time.step = step;
  return scene;
}

double errorOf(const Scene& scene, const Measure& m) {
  Sample sample;
  measureContacts(scene, sample);
  return sample.values.at(m.name);
}

TEST(DampedContact, IsTheClosedForm) {
  const double m = 2.5e-5, k = 2000.0;
  const DampedContact contact{m, k, dampingFor(0.9, k, m)};
  EXPECT_NEAR(contact.restitution(), 0.9, 1e-12);
  EXPECT_NEAR(contact.rate(0.0), 1.0, 1e-12);
  EXPECT_NEAR(contact.overlap(contact.duration()), 0.0, 1e-12);
  EXPECT_GT(contact.grossImpulse(), m * 1.9);
  EXPECT_LT(contact.grossImpulse(), m * 1.95);
  const DampedContact elastic{m, k, 0.0};
  EXPECT_NEAR(elastic.grossImpulse(), 2.0 * m, 1e-12 * m);
  EXPECT_FALSE((DampedContact{m, k, 3.0 * std::sqrt(k * m)}.rebounds()));
}

// With a fine step every integrator comes to the closed forms: of restitution, duration and sliding.
TEST(ContactErrors, VanishWithTheStep) {
  for (std::size_t i = 0; i < modelTable<Integrator>.size(); ++i) {
    const Scene scene = spheres(static_cast<Integrator>(i), 2.5e-7);
    EXPECT_LT(errorOf(scene, measure::restitution), 1e-4) << modelTable<Integrator>[i].name;
    EXPECT_LT(errorOf(scene, measure::duration), 1e-3) << modelTable<Integrator>[i].name;
    EXPECT_LT(errorOf(scene, measure::oblique), 1e-4) << modelTable<Integrator>[i].name;
    EXPECT_LT(errorOf(scene, measure::interior), 1e-3) << modelTable<Integrator>[i].name;
  }
}

// Within a contact Verlet is of order 2 and Runge-Kutta of 4; where the dashpot sets in and lets go within
// steps, the whole is of order 1, and of 2 where its force is shared out to the part of the step it acts in.
TEST(ContactErrors, HaveTheOrdersOfTheory) {
  const auto order = [](Integrator integrator, const Measure& m, double step) {
    return std::log2(errorOf(spheres(integrator, step), m) / errorOf(spheres(integrator, 0.5 * step), m));
  };
  EXPECT_NEAR(order(Integrator::velocityVerlet, measure::interior, 4e-5), 2.0, 0.2);
  EXPECT_NEAR(order(Integrator::rk4, measure::interior, 8e-5), 4.0, 0.5);
  EXPECT_NEAR(order(Integrator::velocityVerlet, measure::restitution, 1e-5), 1.0, 0.3);
  EXPECT_NEAR(order(Integrator::rk4, measure::restitution, 1e-5), 1.0, 0.3);
  EXPECT_NEAR(order(Integrator::verletOnset, measure::restitution, 1e-5), 2.0, 0.3);
}

TEST(ContactErrors, OfAChosenStepAreWithinItsTarget) {
  Scene scene = spheres(Integrator::velocityVerlet, 1e-5);
  scene.time.step = StepLength::automatic();
  for (const double target : {0.03, 0.003}) {
    scene.time.error = target;
    const double worst = errorOf(scene, measure::worstRestitution);
    EXPECT_LT(worst, target);
    EXPECT_GT(worst, 0.05 * target);  // and not by far
  }
}

TEST(ContactErrors, NothingIsMeasuredOfWhatDoesNotRebound) {
  Scene scene = spheres(Integrator::velocityVerlet, 1e-5);
  scene.contacts.restitution.reset();
  scene.contacts.damping = 10.0;
  Sample sample;
  measureContacts(scene, sample);
  EXPECT_TRUE(sample.values.empty());
}

TEST(Drift, FallsWithTheStepAndCanBeStopped) {
  const auto drift = [](double step) {
    Sample sample;
    EXPECT_TRUE(measureDrift(
        spheres(Integrator::velocityVerlet, step), [] { return false; }, sample));
    return sample.values.at(measure::drift.name);
  };
  EXPECT_LT(drift(5e-6), 0.5 * drift(4e-5));
  Sample sample;
  EXPECT_FALSE(measureDrift(
      spheres(Integrator::velocityVerlet, 1e-5), [] { return true; }, sample));
  EXPECT_TRUE(sample.values.empty());
}

}  // namespace
}  // namespace bedmix
