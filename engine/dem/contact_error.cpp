// SPDX-License-Identifier: MIT
#include "engine/dem/contact_error.h"

#include "engine/core/particle_list.h"
#include "engine/dem/particle_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bedmix {

namespace {

constexpr double coarsest = 1.0 / 14.0;                    // of T
constexpr double ratio = 1.0 / (1.0 + 0.189207115002721);  // of neighbouring steps: 2^-1/4
constexpr int measuredSteps = 21;                          // down to T/448
constexpr int endPhases = 8;                               // steps tried for each of them, down to the next
constexpr int phases = 16;                                 // of a step at which contacts begin
constexpr double allowance = 1.1;                          // for the phases in between

double exactRestitution(const Scene& scene) {
  const double m = 0.5 * lightestMass(scene);
  const double zeta = pairDamping(scene) / (2.0 * std::sqrt(m * normalStiffness(scene)));
  return zeta < 1.0 ? std::exp(-std::numbers::pi * zeta / std::sqrt(1.0 - zeta * zeta)) : 0.0;
}

/// Largest departure from the exact restitution over the phases, one pair above the other.
double worstRebound(Scene scene, double step, double exact) {
  scene.time.step = step;
  const double d = scene.particles.diameter, duration = contactTimeScale(scene) / std::sqrt(8.0);
  const double speed = 0.01 * d / duration;
  std::vector<Vec2> places;
  for (int p = 0; p < phases; ++p) {
    const double gap = (1.0 + (p + 0.5) / phases) * speed * step, y = 2.0 * d * p;
    places.push_back({0.0, y});
    places.push_back({d + gap, y});
  }
  const auto solver = ParticleSolver::make(scene, makeParticles(scene, places), {});
  for (int p = 0; p < phases; ++p) {
    solver->particles().velocity[2 * p].x = 0.5 * speed;
    solver->particles().velocity[2 * p + 1].x = -0.5 * speed;
  }
  if (solver->advance(std::llround(3.0 + 2.0 * duration / step)))
    return std::numeric_limits<double>::infinity();
  const Particles after = inOrderOfIds(solver->particles());
  double worst = 0.0;
  for (int p = 0; p < phases; ++p) {
    const double parting = after.velocity[2 * p + 1].x - after.velocity[2 * p].x;
    worst = std::max(worst, std::abs(parting / speed - exact));
  }
  return worst;
}

}  // namespace

ContactError::ContactError(const Scene& scene) {
  Scene pair;
  pair.gravity = 0.0;
  const Scene alike = ofLightest(scene);
  pair.particles = alike.particles;
  pair.contacts = alike.contacts;
  pair.contacts.friction.reset();
  pair.time.integrator = scene.time.integrator;
  const double exact = exactRestitution(pair);
  double step = coarsest * contactTimeScale(pair);
  for (int k = 0; k < measuredSteps; ++k, step *= ratio) {
    double worst = 0.0;
    for (int e = 0; e < endPhases; ++e)
      worst = std::max(worst, worstRebound(pair, step * (1.0 - (1.0 - ratio) * e / endPhases), exact));
    measured_.push_back({step, allowance * worst});
  }
  std::reverse(measured_.begin(), measured_.end());
  for (std::size_t k = 1; k < measured_.size(); ++k)
    measured_[k].error = std::max(measured_[k].error, measured_[k - 1].error);
}

double ContactError::at(double step) const {
  const Measured& finest = measured_.front();
  if (step <= finest.step) return finest.error * (step / finest.step);
  for (const Measured& m : measured_)
    if (step <= m.step) return m.error;
  return std::numeric_limits<double>::infinity();
}

double ContactError::largestStep(double closing, double allowed) const {
  for (std::size_t k = measured_.size(); k-- > 0;)
    if (measured_[k].error * closing <= allowed) return measured_[k].step;
  const Measured& finest = measured_.front();
  return finest.step * (allowed / (finest.error * closing));
}

}  // namespace bedmix
