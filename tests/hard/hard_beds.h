// SPDX-License-Identifier: MIT
#pragma once

#include "engine/simulation.h"
#include "tests/dem/small_beds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace bedmix::hard {

using std::numbers::pi;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Advances; what must not fail in a case ends it.
inline void go(ParticleSolver& solver, std::int64_t steps) {
  if (const auto trouble = solver.advance(steps))
    throw std::runtime_error(
        fmt::format("particle {}: {} ({})", trouble->particle, trouble->value, trouble->stage));
}
inline void go(Simulation& simulation, std::int64_t steps) {
  if (const auto trouble = simulation.advance(steps)) throw std::runtime_error(*trouble);
}

inline double energy(const ParticleSolver& solver) {
  return solver.kineticEnergy() + solver.elasticEnergy() + solver.potentialEnergy();
}
inline double fastest(const Particles& p) {
  double speed = 0.0;
  for (const Vec2 v : p.velocity) speed = std::max(speed, norm(v));
  return speed;
}
/// w dt of two spheres, w^2 = 2 k/m.
inline double pairAngle(const Scene& scene) {
  return scene.time.step * std::sqrt(2.0 * scene.contacts.stiffness / particleMass(scene));
}

}  // namespace bedmix::hard
