// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene_reader.h"
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
  return scene.time.step * std::sqrt(2.0 * normalStiffness(scene) / particleMass(scene));
}

/// What a check's text begins with where it is not the default integrator that is checked.
inline std::string named(const Scene& scene) {
  if (scene.time.integrator == Integrator::velocityVerlet) return "";
  return std::string(modelName(scene.time.integrator)) + ": ";
}

/// Whether check refuses a scene because of this key.
inline bool refused(const Scene& scene, const std::string& path) {
  const auto all = contradictions(scene);
  return std::any_of(all.begin(), all.end(), [&](const Contradiction& c) { return c.path == path; });
}

/// Touching spheres of diameter d, every other row one fewer, over the floor of a box they just fit.
inline std::vector<Vec2> hexagonal(double d, int columns, int rows) {
  std::vector<Vec2> sites;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns - row % 2; ++column)
      sites.push_back({d * (0.5 + column + 0.5 * (row % 2)), d * (0.5 + row * std::sqrt(0.75))});
  return sites;
}

}  // namespace bedmix::hard
