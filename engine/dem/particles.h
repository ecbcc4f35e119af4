// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/core/state_bytes.h"
#include "engine/core/vec2.h"
#include "engine/dem/population.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace bedmix {

/// The spheres of a bed; one array a quantity. Whoever advances them may change their order, to
/// keep neighbours in space neighbours in memory: `id` tells who is where.
struct Particles {
  double radius = 0.0;   // m, of all where all are alike; else of the largest
  double mass = 0.0;     // kg, likewise
  double inertia = 0.0;  // kg m2, 2/5 m r^2
  /// Empty where all are alike. Kinds are those of particleKinds(). They follow from `id` and the scene.
  std::vector<double> radii;   // m
  std::vector<double> masses;  // kg
  std::vector<std::uint8_t> kinds;
  /// With virtual mass, else empty: all that forces accelerate, kg, and the radius, m, of a sphere that has
  /// so much and turns as the particle does. Whoever has set them sets them again when the particles are
  /// loaded.
  std::vector<double> inert, gyration;
  std::vector<std::int32_t> id;
  std::vector<Vec2> position;  // m
  std::vector<Vec2> velocity;  // m/s
  std::vector<double> spin;    // rad/s, counter-clockwise; empty without friction
  /// Forces of others than contacts and gravity are external - drag velocity; they act until whoever sets
  /// them changes them. All three are empty where there are none.
  std::vector<Vec2> external;  // N
  std::vector<double> drag;    // kg/s
  /// Where whoever set the drag then foresaw the particle when it is set next, m: drag accounts for the
  /// difference.
  std::vector<Vec2> foreseen;

  /// Which columns there are, also of no particles.
  struct Columns {
    bool spin = false, sizes = false, external = false, inertia = false;
  };
  Columns columns;

  std::size_t size() const { return position.size(); }
  bool areMixed() const { return !radii.empty(); }
  double radiusOf(std::size_t i) const { return areMixed() ? radii[i] : radius; }
  double massOf(std::size_t i) const { return areMixed() ? masses[i] : mass; }
  /// Masses that forces accelerate; null where all are `mass`.
  const double* inertial() const {
    const std::vector<double>& own = inert.empty() ? masses : inert;
    return own.empty() ? nullptr : own.data();
  }
  double inertiaOf(std::size_t i) const {
    return areMixed() ? 0.4 * masses[i] * radii[i] * radii[i] : inertia;
  }
  /// Gives every particle an external force and a drag coefficient, both zero, foreseen where it is.
  void addExternalForces();
  /// Gives every particle an inertia of its own, to be set before the next step.
  void addInertia();

  /// Particles go to `places`, which ascend, or away where that is negative; newcomers stand behind them.
  void exchange(const std::vector<std::int32_t>& places, const std::vector<PopulationChange::Newcomer>& come);

  void save(StateWriter& out) const;
  /// Into as many particles, of the same scene, with external forces where those have them. False where
  /// `in` is not what save() wrote of them.
  [[nodiscard]] bool load(StateReader& in);
};

/// The scene's spheres at rest with their centres at `positions`, m; ids count up from 0.
Particles makeParticles(const Scene& scene, const std::vector<Vec2>& positions);
/// The same particles in the order of their ids.
Particles inOrderOfIds(const Particles& particles);
/// Whether all are at finite places.
bool isFinite(const Particles& particles);

}  // namespace bedmix
