// SPDX-License-Identifier: MIT
#include "engine/dem/bed_state.h"

#include <algorithm>
#include <utility>

namespace bedmix {

namespace {

/// Moves two arrays to a new order by way of a third, which is as long; either may be empty.
template <class Number>
void permute(const std::vector<std::int32_t>& order, std::vector<Vec2>& vectors, std::vector<Number>& numbers,
             std::vector<Load>& spare) {
  for (std::size_t k = 0; k < vectors.size(); ++k) spare[k].force = vectors[order[k]];
  for (std::size_t k = 0; k < numbers.size(); ++k) spare[k].torque = numbers[order[k]];
  for (std::size_t k = 0; k < vectors.size(); ++k) vectors[k] = spare[k].force;
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = static_cast<Number>(spare[k].torque);
}

}  // namespace

BedState::BedState(const Scene& scene, Particles start, const std::vector<WallSegment>& walls, ThreadTeam& t)
    : particles(std::move(start)),
      contacts(scene, walls, particles.size()),
      loads(particles.size()),
      bodies(particles.size()),
      spinAhead(particles.spin.size()),
      gravity(scene.gravity),
      step(scene.time.step.valueOr(longestStep(scene))),
      team(t) {
  placeBodies();
}

void BedState::placeBodies() {
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i] = {particles.position[i], particles.velocity[i]};
  spinAhead = particles.spin;
}

double BedState::fastestWall() const {
  double fastest = 0.0;
  for (const WallShape& wall : contacts.walls()) fastest = std::max(fastest, wall.fastest());
  return fastest;
}

// Loads are about to be evaluated anew; until then they lend their memory.
bool BedState::sort() {
  comeIn([this](std::size_t i) { return bodies[i].position; });
  if (!contacts.sort(bodies)) return false;
  const std::vector<std::int32_t>& order = contacts.order();
  Particles& p = particles;
  permute(order, p.position, p.id, loads);
  permute(order, p.velocity, p.spin, loads);
  permute(order, p.external, p.drag, loads);
  permute(order, p.foreseen, spinAhead, loads);
  std::vector<Vec2> none;
  permute(order, none, p.radii, loads);
  permute(order, none, p.masses, loads);
  permute(order, none, p.inert, loads);
  permute(order, none, p.gyration, loads);
  permute(order, none, p.kinds, loads);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Body& b = bodies[order[k]];
    loads[k] = {b.position, b.velocity.x, b.velocity.y};
  }
  for (std::size_t k = 0; k < bodies.size(); ++k)
    bodies[k] = {loads[k].force, {loads[k].torque, loads[k].unused}};
  std::fill(loads.begin(), loads.end(), Load{});
  return true;
}

void BedState::exchange(const std::vector<std::int32_t>& places,
                        const std::vector<PopulationChange::Newcomer>& come) {
  particles.exchange(places, come);
  keepPlaces(loads, places);
  loads.resize(particles.size());
  bodies.resize(particles.size());
  spinAhead.resize(particles.spin.size());
  contacts.renumber(places);
  placeBodies();
}

void BedState::save(StateWriter& out, bool begun) const {
  particles.save(out);
  if (!begun) return;
  contacts.save(out);
  out.putAll(loads);
  out.put(budget);
}

bool BedState::load(StateReader& in, bool begun) {
  if (!particles.load(in)) return false;
  if (begun && !(contacts.load(in, bodies) && in.getAll(loads) && in.get(budget))) return false;
  placeBodies();
  const double skin = contacts.fullBudget(0.0).outer;
  return budget.outer <= skin && budget.inner <= skin;
}

}  // namespace bedmix
