// SPDX-License-Identifier: MIT
#include "engine/dem/particle_step.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

// Of T. Whoever asks for less of an error than rounding leaves must not wait for ever.
constexpr double shortest = 1e-5;
// Diameters that the fastest goes in a step, or from one choice to the next, at most: beyond, impacts are
// foreseen that do not come. But so many of the longest steps are taken at once.
constexpr double way = 0.1;
constexpr double stepsAtOnce = 2.0;
constexpr double humming = 0.1;  // sqrt(g d), of a packed bed with friction between T/14 and T/22
constexpr double calm = 0.8, neighbours = 6.0;
constexpr double tiny = 1e-300;  // m/s, keeps quotients finite

}  // namespace

double ParticleStep::limit(const Scene& scene) {
  const double resolved = scene.time.error < humming ? contactTimeScale(scene) / 25.0 : longestStep(scene);
  return std::min(resolved, calm * particleMass(scene) / (neighbours * pairDamping(scene)));
}

ParticleStep::ParticleStep(const Scene& scene)
    : error_(scene),
      allowed_(scene.time.error),
      hasGravity_(scene.gravity > 0.0),
      limit_(limit(scene)),
      shortest_(shortest * contactTimeScale(scene)),
      nearest_(stepsAtOnce * limit_),
      farthest_(contactTimeScale(scene)),
      way_(way * scene.particles.diameter) {
  if (hasGravity_) allowed_ *= std::sqrt(scene.gravity * scene.particles.diameter);
}

double ParticleStep::longest(double span, ParticleSolver& solver) const {
  const double closing = solver.closingSpeed(span);
  const double step = error_.largestStep(closing, hasGravity_ ? allowed_ : allowed_ * closing);
  return std::max(shortest_, std::min({limit_, step, way_ / std::max(solver.fastest().speed, tiny)}));
}

ParticleStep::Outcome ParticleStep::advance(double span, ParticleSolver& solver) const {
  Outcome outcome;
  for (double left = span; left > 0.0 && !outcome.trouble;) {
    const double ahead = std::clamp(way_ / std::max(solver.fastest().speed, tiny), nearest_, farthest_);
    const double parts = std::ceil(left / ahead), part = left / parts;
    const double steps = std::ceil(part / longest(part, solver));
    solver.setStep(part / steps);
    outcome.trouble = solver.advance(static_cast<std::int64_t>(steps));
    const double taken = outcome.trouble ? static_cast<double>(outcome.trouble->steps) : steps;
    outcome.steps += static_cast<std::int64_t>(taken);
    outcome.seconds += taken / steps * part;
    left = parts > 1.0 ? left - part : 0.0;
  }
  return outcome;
}

}  // namespace bedmix
