// SPDX-License-Identifier: MIT
#include "tests/dem/integrators.h"
#include "tests/dem/small_beds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numbers>
#include <span>

// The orders at which what integrators make of a contact comes near the exact solution of the linear law:
// while it lasts, where forces are smooth, and as a whole, where they are not.

namespace bedmix {
namespace {

using std::numbers::pi;

/// Slope of a straight line through logarithms.
double fittedOrder(std::span<const double> steps, std::span<const double> errors) {
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  const double n = static_cast<double>(steps.size());
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double a = std::log(steps[k]), b = std::log(errors[k]);
    x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

/// What spheres err by that hit the floor, of the speeds they hit it with; of the time they touch it.
struct Errors {
  double rebound = 0.0, slip = 0.0, duration = 0.0;
  void keepLarger(const Errors& e) {
    rebound = std::max(rebound, e.rebound);
    slip = std::max(slip, e.slip);
    duration = std::max(duration, e.duration);
  }
};

/// Orders of a whole contact.
struct Whole {
  double rebound, slip, duration;
};

struct Orders {
  Integrator integrator;
  double smooth;                   // of a contact that neither begins nor ends
  double rebound, slip, duration;  // of a whole one
  double elastic;                  // of a whole one without a dashpot
};

class Order : public testing::TestWithParam<Orders> {
 protected:
  static constexpr double down = 0.2, along = 0.1;  // m/s

  // Tangential constants 2/7 of the normal ones: both directions swing alike, and where nothing slides the
  // surface rebounds like the centre.
  Order() {
    scene_.contacts.friction = FrictionSettings{.coefficient = 1e9};
    scene_.time.integrator = GetParam().integrator;
  }

  double restitution() const { return *scene_.contacts.restitution; }
  DampedOscillator contact(double displacement, double velocity) const {
    return {particleMass(scene_), normalStiffness(scene_), wallDamping(scene_), displacement, velocity};
  }

  /// The worst of spheres that meet the floor at all phases of a step.
  Errors impacts(double step, double speedAlong, double slipAfter) const {
    constexpr int count = 24;
    Scene scene = scene_;
    scene.time.step = step;
    const double r = scene.particles.diameter / 2.0, lasts = pi / contact(0.0, down).frequency();
    std::vector<Vec2> places;
    for (int i = 0; i < count; ++i)
      places.push_back({4.0 * r * i, r + (1.0 + (i + 0.5) / count) * down * step});
    const auto solver = solverAt(scene, places, wideFloor());
    for (Vec2& v : solver->particles().velocity) v = {speedAlong, -down};
    const std::int64_t steps = std::llround(1.3 * lasts / step) + 4;
    EXPECT_FALSE(solver->advance(steps));
    EXPECT_EQ(solver->contactCount(), 0);
    const Particles p = inOrderOfIds(solver->particles());
    Errors worst;
    for (int i = 0; i < count; ++i) {
      const double sinceItLeft = (p.position[i].y - r) / p.velocity[i].y, met = (places[i].y - r) / down;
      const double slip = p.velocity[i].x + r * p.spin[i];
      worst.keepLarger({std::abs(p.velocity[i].y / down - restitution()), std::abs(slip - slipAfter) / down,
                        std::abs((static_cast<double>(steps) * step - sinceItLeft - met) / lasts - 1.0)});
    }
    return worst;
  }

  /// Fitted to steps from T/160 to T/2560, each the worst of some that are a little shorter, so that contacts
  /// end at all phases as well.
  Whole wholeContacts(double speedAlong, double slipAfter) const {
    std::vector<double> steps;
    std::vector<Errors> errors;
    for (double ofScale = 160.0; ofScale < 3000.0; ofScale *= 2.0) {
      steps.push_back(contactTimeScale(scene_) / ofScale);
      errors.emplace_back();
      for (int e = 0; e < 8; ++e)
        errors.back().keepLarger(impacts(steps.back() * (1.0 - 0.02 * e), speedAlong, slipAfter));
    }
    const auto order = [&](double Errors::*which) {
      std::vector<double> values;
      for (const Errors& e : errors) values.push_back(e.*which);
      return fittedOrder(steps, values);
    };
    return {.rebound = order(&Errors::rebound),
            .slip = order(&Errors::slip),
            .duration = order(&Errors::duration)};
  }

  void tell(const char* what, double order) {
    RecordProperty(what, std::to_string(order));
    std::printf("%s, %s: order %.2f\n", std::string(modelName(GetParam().integrator)).c_str(), what, order);
  }

  Scene scene_ = smoothSpheres();
};

TEST_P(Order, WithinAContact) {
  constexpr double overlap = 5e-5, time = 1.6e-4;
  const double r = scene_.particles.diameter / 2.0;
  const DampedOscillator normal = contact(overlap, down), surface = contact(0.0, along);
  std::vector<double> steps, errors;
  for (int n = 8; n <= 64; n *= 2) {
    scene_.time.step = time / n;
    const auto solver = solverAt(scene_, {{0.0, r - overlap}}, wideFloor());
    solver->particles().velocity[0] = {along, -down};
    ASSERT_FALSE(solver->advance(n));
    ASSERT_EQ(solver->contactCount(), 1);
    const Particles& p = solver->particles();
    steps.push_back(scene_.time.step);
    errors.push_back(
        std::max({std::abs(-p.velocity[0].y - normal.velocityAt(time)) / down,
                  std::abs(r - p.position[0].y - normal.displacementAt(time)) * normal.frequency() / down,
                  std::abs(p.velocity[0].x + r * p.spin[0] - surface.velocityAt(time)) / along}));
  }
  const double order = fittedOrder(steps, errors);
  tell("within a contact", order);
  EXPECT_NEAR(order, GetParam().smooth, 0.1);
}

// Where contacts begin and end inside a step the dashpot's force jumps, which costs all but verlet-onset an
// order or more.
TEST_P(Order, OfAContactThatSticks) {
  const Whole found = wholeContacts(along, -restitution() * along);
  tell("restitution", found.rebound);
  tell("slip where it sticks", found.slip);
  tell("duration", found.duration);
  EXPECT_NEAR(found.rebound, GetParam().rebound, 0.2);
  EXPECT_NEAR(found.slip, GetParam().slip, 0.2);
  EXPECT_NEAR(found.duration, GetParam().duration, 0.2);
}

// In full sliding the tangential impulse is mu times that of |F_n|, which pulls from the moment of the
// largest rebound speed on.
TEST_P(Order, OfAContactThatSlides) {
  constexpr double fast = 1.0, mu = 0.1;
  scene_.contacts.friction->coefficient = mu;
  const DampedOscillator normal = contact(0.0, down);
  const double a = normal.decay(), w = normal.frequency();
  const double fastest = -normal.velocityAt((pi - std::atan2(2.0 * a * w, w * w - a * a)) / w);
  const double impulse = mu * (down * (1.0 - restitution()) + 2.0 * fastest);  // over the mass
  const Whole found = wholeContacts(fast, fast - 3.5 * impulse);
  tell("slip where it slides", found.slip);
  EXPECT_NEAR(found.slip, GetParam().slip, 0.2);
}

TEST_P(Order, OfAnElasticContact) {
  scene_.contacts.restitution = 1.0;
  const Whole found = wholeContacts(0.0, 0.0);
  tell("elastic rebound", found.rebound);
  EXPECT_NEAR(found.rebound, GetParam().elastic, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Integrators, Order,
                         testing::Values(Orders{Integrator::velocityVerlet, 2.0, 1.0, 1.0, 2.0, 2.0},
                                         Orders{Integrator::rk4, 4.0, 1.0, 1.0, 2.0, 2.0},
                                         Orders{Integrator::symplecticEuler, 1.0, 1.0, 1.0, 1.0, 2.0},
                                         Orders{Integrator::verletOnset, 2.0, 2.0, 2.0, 2.0, 4.0}),
                         [](const auto& tried) {
                           return nameOfIntegrator({tried.param.integrator, tried.index});
                         });

}  // namespace
}  // namespace bedmix
