// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dem/particle_solver.h"

#include <cmath>
#include <memory>
#include <vector>

namespace bedmix {

/// The paper's spheres without gravity and friction, restitution 0.9.
inline Scene smoothSpheres() {
  Scene scene;
  scene.gravity = 0.0;
  scene.contacts.restitution = 0.9;
  return scene;
}

/// A floor at y = 0 that is wider than anything here moves.
inline std::vector<WallSegment> wideFloor() { return {{{-10.0, 0.0}, {10.0, 0.0}}}; }

/// A closed box from the origin to (width, height).
inline std::vector<WallSegment> closedBox(double width, double height) {
  const Vec2 corners[] = {{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}, {0.0, 0.0}};
  std::vector<WallSegment> walls;
  for (int c = 0; c < 4; ++c) walls.push_back({corners[c], corners[c + 1], true, false});
  return walls;
}

inline std::unique_ptr<ParticleSolver> solverAt(const Scene& scene, const std::vector<Vec2>& positions,
                                                const std::vector<WallSegment>& walls = {}) {
  return ParticleSolver::make(scene, makeParticles(scene, positions), walls);
}

/// A mass on a damped spring, let go at `displacement` (m) with `velocity` (m/s); underdamped.
struct DampedOscillator {
  double mass, stiffness, damping, displacement, velocity;

  double decay() const { return damping / (2.0 * mass); }
  double frequency() const { return std::sqrt(stiffness / mass - decay() * decay()); }
  double displacementAt(double t) const {
    const double a = decay(), w = frequency();
    return std::exp(-a * t) *
           (displacement * std::cos(w * t) + (velocity + a * displacement) / w * std::sin(w * t));
  }
  double velocityAt(double t) const {
    const double a = decay(), w = frequency(), b = (velocity + a * displacement) / w;
    return std::exp(-a * t) *
           ((w * b - a * displacement) * std::cos(w * t) - (w * displacement + a * b) * std::sin(w * t));
  }
};

}  // namespace bedmix
