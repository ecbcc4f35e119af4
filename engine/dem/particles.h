// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/core/vec2.h"

#include <cstddef>
#include <vector>

namespace bedmix {

/// The spheres of a bed, all alike, in the order of their ids 0 to size() - 1; one array a component.
struct Particles {
  double radius = 0.0;         // m
  double mass = 0.0;           // kg
  double inertia = 0.0;        // kg m2, 2/5 m r^2
  std::vector<double> x, y;    // m
  std::vector<double> vx, vy;  // m/s
  std::vector<double> spin;    // rad/s, counter-clockwise; empty without friction
  /// Forces of others than contacts and gravity, N; they act until whoever sets them changes them.
  std::vector<double> fx, fy;

  std::size_t size() const { return x.size(); }
};

/// The scene's spheres at rest with their centres at `positions`, m.
Particles makeParticles(const Scene& scene, const std::vector<Vec2>& positions);
/// Whether all are at finite places.
bool isFinite(const Particles& particles);

}  // namespace bedmix
