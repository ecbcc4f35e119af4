// SPDX-License-Identifier: MIT
#include "engine/dem/particles.h"

#include "engine/core/particle_list.h"
#include "engine/dem/population.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace bedmix {

void Particles::addExternalForces() {
  columns.external = true;
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
  const Roster roster(id);
  const std::vector<std::int32_t>& ids = roster.ids();
  if (std::adjacent_find(ids.begin(), ids.end()) != ids.end() || (!ids.empty() && ids.front() < 0))
    return false;
  if (areMixed()) {  // what was made stands in the order of the ids
    const std::vector<double> radiiById = radii, massesById = masses;
    const std::vector<std::uint8_t> kindsById = kinds;
    for (std::size_t k = 0; k < size(); ++k) {
      radii[k] = radiiById[roster.rowOf(id[k])];
      masses[k] = massesById[roster.rowOf(id[k])];
      kinds[k] = kindsById[roster.rowOf(id[k])];
    }
  }
  return true;
}

void Particles::addInertia() {
  columns.inertia = true;
  inert.resize(size(), mass);
  gyration.resize(size(), radius);
}

void Particles::exchange(const std::vector<std::int32_t>& places,
                         const std::vector<PopulationChange::Newcomer>& come) {
  const auto keep = [&](auto& column) { keepPlaces(column, places); };
  keep(id), keep(position), keep(velocity), keep(spin), keep(external), keep(drag), keep(foreseen);
  keep(radii), keep(masses), keep(kinds), keep(inert), keep(gyration);
  for (const PopulationChange::Newcomer& newcomer : come) {
    id.push_back(newcomer.id);
    position.push_back(newcomer.position);
    velocity.push_back(newcomer.velocity);
    if (columns.spin) spin.push_back(0.0);
    if (columns.external) {
      external.push_back({});
      drag.push_back(0.0);
      foreseen.push_back(newcomer.position);
    }
    if (columns.inertia) {
      inert.push_back(newcomer.mass);
      gyration.push_back(newcomer.radius);
    }
    if (columns.sizes) {
      radii.push_back(newcomer.radius);
      masses.push_back(newcomer.mass);
      kinds.push_back(newcomer.kind);
    }
  }
}

namespace {

void addSizes(const Scene& scene, Particles& p) {
  const std::vector<ParticleKind> kinds = particleKinds(scene);
  ParticleList list = particleList(scene);
  p.radii = std::move(list.radii);
  p.kinds = std::move(list.kinds);
  // Who has been fed is not of the list; what he is a checkpoint tells.
  p.radii.resize(p.size(), 0.5 * scene.particles.diameter);
  p.kinds.resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) p.masses.push_back(massOf(kinds[p.kinds[i]], p.radii[i]));
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
  p.columns = {.spin = scene.contacts.friction.has_value(), .sizes = isMixed(scene)};
  if (p.columns.spin) p.spin.assign(n, 0.0);
  if (p.columns.sizes) addSizes(scene, p);
  return p;
}

Particles inOrderOfIds(const Particles& particles) {
  Particles sorted = particles;
  const Roster roster(particles.id);
  const auto sort = [&](const auto& from, auto& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[roster.rowOf(particles.id[i])] = from[i];
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
