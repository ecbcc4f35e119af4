// SPDX-License-Identifier: MIT
#include "engine/dem/contact_error.h"

#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

namespace bedmix {
namespace {

/// Worst of some collisions of two spheres, over steps a little shorter than `step` and phases at which they
/// meet.
double worstError(Scene scene, double step) {
  constexpr double speed = 0.3;
  double worst = 0.0;
  for (int c = 0; c < 150; ++c) {
    scene.time.step = step * (1.0 - 0.002 * c);
    const double gap = speed * scene.time.step * (1.0 + std::fmod(0.6180339887 * c, 1.0));
    const auto solver = solverAt(scene, {{0.0, 0.0}, {0.6 * (0.004 + gap), 0.8 * (0.004 + gap)}});
    solver->particles().velocity[0] = {0.6 * speed, 0.8 * speed};
    EXPECT_FALSE(solver->advance(std::llround(0.001 / scene.time.step)));
    const Particles p = inOrderOfIds(solver->particles());
    const double parting = dot(p.velocity[1] - p.velocity[0], {0.6, 0.8}) / speed;
    worst = std::max(worst, std::abs(parting - *scene.contacts.restitution));
  }
  return worst;
}

class ContactErrors : public testing::TestWithParam<Integrator> {
 protected:
  ContactErrors() { scene_.time.integrator = GetParam(); }
  Scene scene_ = smoothSpheres();
};

// No collision errs more than the table tells, but some do by a good part of that.
TEST_P(ContactErrors, BoundCollisions) {
  for (const double restitution : {0.9, 0.5}) {
    scene_.contacts.restitution = restitution;
    const ContactError errors(scene_);
    for (const double ofScale : {16.0, 30.0, 77.0, 150.0, 600.0}) {
      const double step = contactTimeScale(scene_) / ofScale, worst = worstError(scene_, step);
      EXPECT_LE(worst, errors.at(step)) << "T/" << ofScale << ", restitution " << restitution;
      EXPECT_GE(worst, 0.4 * errors.at(step)) << "T/" << ofScale << ", restitution " << restitution;
    }
  }
}

TEST_P(ContactErrors, LargestStepIsWhereTheErrorIsAllowed) {
  const ContactError errors(scene_);
  const double longest = contactTimeScale(scene_) / 14.0;
  EXPECT_DOUBLE_EQ(errors.largestStep(1.0, 1.0), longest);
  EXPECT_DOUBLE_EQ(errors.largestStep(0.0, 1e-9), longest);
  EXPECT_EQ(errors.at(1.01 * longest), std::numeric_limits<double>::infinity());
  double before = longest;
  for (double closing = 1e-3; closing < 1e3; closing *= 1.7) {
    const double allowed = 1e-4, step = errors.largestStep(closing, allowed);
    EXPECT_GT(step, 0.0);
    EXPECT_LE(step, before);
    before = step;
    if (step < longest) {
      EXPECT_LE(errors.at(step) * closing, (1.0 + 1e-12) * allowed);
      EXPECT_GT(errors.at(1.2 * step) * closing, allowed);
    }
  }
  EXPECT_LT(before, longest / 100.0);
}

INSTANTIATE_TEST_SUITE_P(Integrators, ContactErrors, eachIntegrator(), nameOfIntegrator);

}  // namespace
}  // namespace bedmix
