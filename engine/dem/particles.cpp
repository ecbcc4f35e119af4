// SPDX-License-Identifier: MIT
#include "engine/dem/particles.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace bedmix {

void Particles::addExternalForces() {
  external.resize(size());
  drag.resize(size());
  foreseen = position;
}

void Particles::save(StateWriter& out) const {
  out.putAll(id);
  out.putAll(position);
  out.putAll(velocity);
  out.putAll(spin);
  out.putAll(external);
  out.putAll(drag);
  out.putAll(foreseen);
}

bool Particles::load(StateReader& in) {
  if (!(in.getAll(id) && in.getAll(position) && in.getAll(velocity) && in.getAll(spin) &&
        in.getAll(external) && in.getAll(drag) && in.getAll(foreseen)))
    return false;
  std::vector<std::uint8_t> seen(size());
  for (const std::int32_t i : id)
    if (i < 0 || static_cast<std::size_t>(i) >= size() || std::exchange(seen[i], 1)) return false;
  return true;
}

Particles makeParticles(const Scene& scene, const std::vector<Vec2>& positions) {
  const std::size_t n = positions.size();
  Particles p;
  p.radius = scene.particles.diameter / 2.0;
  p.mass = particleMass(scene);
  p.inertia = 0.4 * p.mass * p.radius * p.radius;
  p.id.resize(n);
  std::iota(p.id.begin(), p.id.end(), 0);
  p.position = positions;
  p.velocity.resize(n);
  if (scene.contacts.friction) p.spin.assign(n, 0.0);
  return p;
}

Particles inOrderOfIds(const Particles& particles) {
  Particles sorted = particles;
  const auto sort = [&](const auto& from, auto& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[particles.id[i]] = from[i];
  };
  sort(particles.id, sorted.id);
  sort(particles.position, sorted.position);
  sort(particles.velocity, sorted.velocity);
  sort(particles.spin, sorted.spin);
  sort(particles.external, sorted.external);
  sort(particles.drag, sorted.drag);
  sort(particles.foreseen, sorted.foreseen);
  return sorted;
}

bool isFinite(const Particles& particles) {
  return std::all_of(particles.position.begin(), particles.position.end(),
                     [](Vec2 at) { return std::isfinite(at.x) && std::isfinite(at.y); });
}

}  // namespace bedmix
