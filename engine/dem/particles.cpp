// SPDX-License-Identifier: MIT
#include "engine/dem/particles.h"

#include "engine/core/particle_list.h"

#include <algorithm>
#include <cmath>
#include <numbers>
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
  if (areMixed()) {  // what was made stands in the order of the ids
    const std::vector<double> radiiById = radii, massesById = masses;
    const std::vector<std::uint8_t> kindsById = kinds;
    for (std::size_t k = 0; k < size(); ++k) {
      radii[k] = radiiById[id[k]];
      masses[k] = massesById[id[k]];
      kinds[k] = kindsById[id[k]];
    }
  }
  return true;
}

namespace {

void addSizes(const Scene& scene, Particles& p) {
  const std::vector<ParticleKind> kinds = particleKinds(scene);
  ParticleList list = particleList(scene);
  p.radii = std::move(list.radii);
  p.kinds = std::move(list.kinds);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double r = p.radii[i];
    p.masses.push_back(kinds[p.kinds[i]].density * 4.0 / 3.0 * std::numbers::pi * r * r * r);
  }
  const ParticleRange range = particleRange(scene);
  p.radius = 0.5 * range.largest;
  p.mass = range.heaviest;
  p.inertia = 0.4 * p.mass * p.radius * p.radius;
}

}  // namespace

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
  if (isMixed(scene)) addSizes(scene, p);
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
  sort(particles.radii, sorted.radii);
  sort(particles.masses, sorted.masses);
  sort(particles.inert, sorted.inert);
  sort(particles.gyration, sorted.gyration);
  sort(particles.kinds, sorted.kinds);
  return sorted;
}

bool isFinite(const Particles& particles) {
  return std::all_of(particles.position.begin(), particles.position.end(),
                     [](Vec2 at) { return std::isfinite(at.x) && std::isfinite(at.y); });
}

}  // namespace bedmix
