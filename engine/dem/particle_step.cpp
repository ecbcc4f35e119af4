// SPDX-License-Identifier: MIT
#include "engine/dem/particle_step.h"

#include "engine/core/particle_list.h"

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
  return std::min(resolved, calm * lightestMass(scene) / (neighbours * pairDamping(scene)));
}

ParticleStep::ParticleStep(const Scene& scene)
    : error_(scene),
      allowed_(scene.time.error),
      hasGravity_(scene.gravity > 0.0),
      limit_(limit(scene)),
      shortest_(shortest * contactTimeScale(scene)),
      nearest_(stepsAtOnce * limit_),
      hold_(contactTimeScale(scene)),
      way_(way * particleRange(scene).smallest),
      step_(limit_) {
  if (hasGravity_) allowed_ *= std::sqrt(scene.gravity * particleRange(scene).smallest);
}

double ParticleStep::longest(double span, ParticleSolver& solver) const {
  // A step that ends with the span acts on contacts that begin soon after it, too, as does the next choice.
  const double closing = solver.closingSpeed(span + limit_);
  const double step = error_.largestStep(closing, hasGravity_ ? allowed_ : allowed_ * closing);
  return std::max(shortest_, std::min({limit_, step, way_ / std::max(solver.fastest().speed, tiny)}));
}

// A contact of constant steps keeps its energy to the end, one in which they change by (w dt)2/8 less well:
// the step stays what it is until no impact has asked for it for longer than a contact lasts.
void ParticleStep::follow(double needed, double since) {
  calm_ = needed > step_ ? calm_ + since : 0.0;
  if (needed > step_ && calm_ < hold_) return;
  step_ = needed;
  calm_ = 0.0;
}

ParticleStep::Outcome ParticleStep::advance(double span, ParticleSolver& solver) {
  Outcome outcome;
  double since = 0.0;
  for (double left = span; left > 0.0 && !outcome.trouble;) {
    const double ahead = std::clamp(way_ / std::max(solver.fastest().speed, tiny), nearest_, hold_);
    follow(longest(std::min(left, ahead), solver), since);
    const double all = std::ceil(left / step_), length = left / all;
    const double steps = std::min(all, std::max(1.0, std::floor(ahead / length)));
    solver.setStep(length);
    outcome.trouble = solver.advance(static_cast<std::int64_t>(steps));
    const double taken = outcome.trouble ? static_cast<double>(outcome.trouble->steps) : steps;
    outcome.steps += static_cast<std::int64_t>(taken);
    outcome.seconds += taken * length;
    since = steps * length;
    left = steps < all ? left - since : 0.0;
  }
  calm_ += since;
  return outcome;
}

void ParticleStep::save(StateWriter& out) const {
  out.put(step_);
  out.put(calm_);
}

bool ParticleStep::load(StateReader& in) { return in.get(step_) && step_ > 0.0 && in.get(calm_); }

}  // namespace bedmix
