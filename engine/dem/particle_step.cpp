// SPDX-License-Identifier: MIT
#include "engine/dem/particle_step.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

// Of T. Whoever asks for less of an error than rounding leaves must not wait for ever.
constexpr double shortest = 1e-5;
constexpr double furthest = 0.1;  // diameters in a step

}  // namespace

ParticleStep::ParticleStep(const Scene& scene)
    : error_(scene),
      allowed_(scene.time.error),
      relative_(!(scene.gravity > 0.0)),
      shortest_(shortest * contactTimeScale(scene)),
      furthest_(furthest * scene.particles.diameter) {
  if (!relative_) allowed_ *= std::sqrt(scene.gravity * scene.particles.diameter);
}

std::int64_t ParticleStep::divide(double span, ParticleSolver& solver) const {
  const double closing = solver.closingSpeed(span);
  double longest = error_.largestStep(closing, relative_ ? allowed_ * closing : allowed_);
  longest = std::min(longest, furthest_ / std::max(solver.fastest().speed, 1e-300));
  const double steps = std::max(1.0, std::ceil(span / std::max(longest, shortest_)));
  solver.setStep(span / steps);
  return static_cast<std::int64_t>(steps);
}

}  // namespace bedmix
