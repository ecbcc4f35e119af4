// SPDX-License-Identifier: MIT
#include "engine/dem/particles.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

Particles makeParticles(const Scene& scene, const std::vector<Vec2>& positions) {
  const std::size_t n = positions.size();
  Particles p;
  p.radius = scene.particles.diameter / 2.0;
  p.mass = particleMass(scene);
  p.inertia = 0.4 * p.mass * p.radius * p.radius;
  p.x.reserve(n);
  p.y.reserve(n);
  for (const Vec2& at : positions) {
    p.x.push_back(at.x);
    p.y.push_back(at.y);
  }
  p.vx.assign(n, 0.0);
  p.vy.assign(n, 0.0);
  p.fx.assign(n, 0.0);
  p.fy.assign(n, 0.0);
  if (scene.contacts.friction) p.spin.assign(n, 0.0);
  return p;
}

bool isFinite(const Particles& particles) {
  const auto finite = [](double v) { return std::isfinite(v); };
  return std::all_of(particles.x.begin(), particles.x.end(), finite) &&
         std::all_of(particles.y.begin(), particles.y.end(), finite);
}

}  // namespace bedmix
