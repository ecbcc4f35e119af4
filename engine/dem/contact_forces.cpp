// SPDX-License-Identifier: MIT
#include "engine/dem/contact_forces.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

/// Keeps the deepest contact of a block; `overlap(slot)`, m, is asked only where there is a deeper one.
template <class Overlap>
void watch(const BedState& bed, ContactBlock& block, const ContactSlots& slots, Range range, double reach,
           const KernelReport& report, Overlap&& overlap) {
  block.touching += report.touching;
  const double record = reach - block.deepest;
  if (!(report.closest2 < record * record)) return;
  block.deepest = reach - std::sqrt(report.closest2);
  double deepest = 0.0;
  for (std::size_t c = range.begin; c < range.end; ++c) {
    const double here = overlap(c);
    if (here > deepest) block.deepestId = bed.particles.id[slots.first[c]];
    deepest = std::max(deepest, here);
  }
}

void watchPairs(const BedState& bed, ContactBlock& block, const ContactSlots& slots, Range range,
                const Motion& at, double reach, const KernelReport& report) {
  const Particles& p = bed.particles;
  watch(bed, block, slots, range, reach, report, [&](std::size_t c) {
    const std::int32_t i = slots.first[c], j = slots.second[c];
    Vec2 apart = at.body[j].position - at.body[i].position;
    if (bed.contacts.period().isOn()) apart = bed.contacts.period().nearest(apart);
    return p.radiusOf(i) + p.radiusOf(j) - norm(apart);
  });
}

}  // namespace

ContactForces::ContactForces(const Scene& scene) {
  const double radius = scene.particles.diameter / 2.0, mass = particleMass(scene);
  const bool friction = scene.contacts.friction.has_value();
  const bool onset = scene.time.integrator == Integrator::verletOnset;
  effects_ = contactEffects(scene);
  const ContactEffects* const effects = effects_ ? &*effects_ : nullptr;
  pair_ = {pairLaw(scene), radius, mass, 0.0, friction, onset, effects};
  wall_ = {wallLaw(scene), radius, mass, 0.0, friction, onset, effects};
}

void ContactForces::addCrossing(BedState& bed, std::size_t b, const Motion& at, const Tangential& t) const {
  ContactBlock& block = bed.contacts.block(b);
  block.touching = 0;
  const ContactSlots& s = block.crossing;
  if (s.count == 0) return;
  const Range all{0, s.count};
  const KernelReport report = pair_.crossing(at, {s.first.data(), s.second.data(), all}, t, bed.loads.data(),
                                             block.crossingLoads.data());
  watchPairs(bed, block, s, all, at, pair_.law.reach, report);
}

void ContactForces::addWalls(BedState& bed, std::size_t b, const Motion& at) const {
  ContactBlock& block = bed.contacts.block(b);
  for (ContactBlock::AtWall& w : block.walls) addWall(bed, block, w, at, inPlace(w.slots));
}

void ContactForces::addNear(BedState& bed, std::size_t b, const Motion& at, Range slots,
                            const Tangential& t) const {
  ContactBlock& block = bed.contacts.block(b);
  const ContactSlots& s = block.near;
  const KernelReport report = pair_.pairs(at, {s.first.data(), s.second.data(), slots}, t, bed.loads.data());
  watchPairs(bed, block, s, slots, at, pair_.law.reach, report);
}

void ContactForces::addWall(BedState& bed, ContactBlock& block, const ContactBlock::AtWall& w,
                            const Motion& at, const Tangential& t) const {
  const ContactSlots& s = w.slots;
  if (s.count == 0) return;
  const WallShape& rest = bed.contacts.walls()[w.wall];
  if (!rest.moves()) return addWall(bed, block, s, rest, at, t);
  addWall(bed, block, s, rest.at(at.time), at, t);
}

void ContactForces::addWall(BedState& bed, ContactBlock& block, const ContactSlots& s, const WallShape& wall,
                            const Motion& at, const Tangential& t) const {
  const KernelReport report = wall_.wall(at, wall, s.first.data(), s.count, t, bed.loads.data());
  watch(bed, block, s, {0, s.count}, wall_.law.reach, report, [&](std::size_t c) {
    Vec2 point;
    const Vec2 centre = at.body[s.first[c]].position;
    return wall.touchPoint(centre, point) ? bed.particles.radiusOf(s.first[c]) - norm(point - centre) : 0.0;
  });
}

void ContactForces::addIncoming(BedState& bed, std::size_t block) {
  for (const ContactBlock::Incoming& in : bed.contacts.block(block).incoming)
    bed.loads[in.particle] += bed.contacts.block(in.block).crossingLoads[in.row];
}

}  // namespace bedmix
