// SPDX-License-Identifier: MIT
#include "engine/dem/bed_state.h"

#include <utility>

namespace bedmix {

namespace {

template <class T>
void permute(const std::vector<std::int32_t>& order, std::vector<T>& values, std::vector<T>& spare) {
  if (values.empty()) return;
  spare.resize(values.size());
  for (std::size_t k = 0; k < order.size(); ++k) spare[k] = values[order[k]];
  values.swap(spare);
}

}  // namespace

BedState::BedState(const Scene& scene, Particles start, const std::vector<WallSegment>& walls, ThreadTeam& t)
    : particles(std::move(start)),
      contacts(scene.particles.diameter, walls, particles.size(), scene.contacts.friction.has_value()),
      loads(particles.size()),
      ahead(particles.size()),
      spinAhead(particles.spin.size()),
      gravity(scene.gravity),
      step(scene.time.step),
      team(t) {}

bool BedState::sort() {
  if (!contacts.sort(particles.position)) return false;
  const std::vector<std::int32_t>& order = contacts.order();
  permute(order, particles.id, spareIds_);
  for (std::vector<Vec2>* values :
       {&particles.position, &particles.velocity, &particles.external, &particles.foreseen, &ahead})
    permute(order, *values, spareVectors_);
  for (std::vector<double>* values : {&particles.spin, &particles.drag, &spinAhead})
    permute(order, *values, spareNumbers_);
  return true;
}

}  // namespace bedmix
