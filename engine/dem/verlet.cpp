// SPDX-License-Identifier: MIT
#include "engine/dem/verlet.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

VelocityVerlet::VelocityVerlet(const Scene& scene, const BedState& bed)
    : atStart_(scene, 0.0),
      contacts_(scene, 0.5 * bed.step),
      spare_(bed.team.size()),
      fastest2_(bed.contacts.blocks()),
      deepest_(bed.contacts.blocks()),
      displacements_(bed.contacts.blocks()) {}

VelocityVerlet::Member VelocityVerlet::start(const BedState& bed, int index) const {
  return {index, bed.team.share(bed.contacts.blocks(), index), bed.budget, {}, {}, {}};
}

// Null where there are none: the kernel leaves out what a scene does not use.
MotionKernel VelocityVerlet::motion(BedState& bed) const {
  Particles& p = bed.particles;
  const auto orNull = [](auto& values) { return values.empty() ? nullptr : values.data(); };
  return {.step = bed.step,
          .gravity = bed.gravity,
          .perMass = 1.0 / p.mass,
          .perInertia = 1.0 / p.inertia,
          .body = bed.bodies.data(),
          .position = p.position.data(),
          .velocity = p.velocity.data(),
          .spin = orNull(p.spin),
          .external = orNull(p.external),
          .drag = orNull(p.drag),
          .loads = bed.loads.data(),
          .spinAhead = bed.spinAhead.data()};
}

void VelocityVerlet::begin(BedState& bed) {
  bed.placeBodies();
  bed.team.run([&](int index) {
    Member m = start(bed, index);
    rebuild(bed, m);
    for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b) evaluate(bed, b, atStart_);
    bed.team.barrier();
    for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b) ContactForces::addIncoming(bed, b);
    if (index == 0) bed.budget = m.budget;
  });
}

StepOutcome VelocityVerlet::advance(BedState& bed, std::int64_t steps, double maxOverlap) {
  if (steps == 0) return {};
  StepOutcome outcome;
  bed.team.run([&](int index) {
    Member m = start(bed, index);
    walk(bed, m, steps, maxOverlap);
    if (index != 0) return;
    outcome = m.outcome;
    bed.budget = m.budget;
    bed.seconds.neighbours += m.seconds.neighbours;
    bed.seconds.contacts += m.seconds.contacts;
    bed.seconds.integrate += m.seconds.integrate;
  });
  for (const double v2 : fastest2_) outcome.finite &= std::isfinite(v2);
  if (outcome.steps < steps || !outcome.finite)
    for (std::size_t i = 0; i < bed.bodies.size(); ++i) bed.particles.position[i] = bed.bodies[i].position;
  return outcome;
}

// Block after block is evaluated and moved at once, while it is in the cache: its contacts are all with
// itself and with later blocks, which have not moved yet. Only blocks whose contacts reach into those of the
// next member come first.
void VelocityVerlet::walk(BedState& bed, Member& m, std::int64_t steps, double maxOverlap) {
  const MotionKernel kernel = motion(bed);
  const auto particles = [&](std::size_t b) { return bed.contacts.block(b).particles; };
  for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b) fastest2_[b] = kernel.drift(particles(b));
  for (std::int64_t& taken = m.outcome.steps; taken < steps;) {
    bed.team.barrier();
    m.lap(m.seconds.integrate);
    if (taken > 0 && *std::max_element(deepest_.begin(), deepest_.end()) > maxOverlap) return;
    m.outcome.finite = keepLists(bed, m);
    m.lap(m.seconds.neighbours);
    if (!m.outcome.finite) return;

    const std::size_t inner =
        m.blocks.size() > bed.contacts.reach() ? m.blocks.end - bed.contacts.reach() : m.blocks.begin;
    for (std::size_t b = inner; b < m.blocks.end; ++b) evaluate(bed, b, contacts_);
    bed.team.barrier();
    const bool last = ++taken == steps;
    for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b) {
      if (b < inner) evaluate(bed, b, contacts_);
      ContactForces::addIncoming(bed, b);
      m.lap(m.seconds.contacts);
      deepest_[b] = bed.contacts.block(b).deepest;
      fastest2_[b] = last ? kernel.kick(particles(b)) : kernel.kickAndDrift(particles(b));
      m.lap(m.seconds.integrate);
    }
  }
}

void VelocityVerlet::evaluate(BedState& bed, std::size_t block, const ContactForces& contacts) const {
  const Motion at{bed.bodies.data(), bed.spinAhead.data()};
  contacts.evaluate(bed, block, at, [](ContactSlots& slots, std::size_t) { return inPlace(slots); });
}

// Every member comes to the same decisions, so that all meet as often.
bool VelocityVerlet::keepLists(BedState& bed, Member& m) {
  const double fastest2 = *std::max_element(fastest2_.begin(), fastest2_.end());
  if (!std::isfinite(fastest2)) return false;
  m.budget.spend(std::sqrt(fastest2) * bed.step);
  if (m.budget.outer < 0.0) {
    for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b)
      displacements_[b] = bed.contacts.displacements(bed.contacts.block(b).particles, bed.bodies);
    bed.team.barrier();
    ContactList::Displacements all;
    for (const ContactList::Displacements& d : displacements_) all.add(d.largest), all.add(d.second);
    m.budget.outer = bed.contacts.remainder(all);
    if (m.budget.outer < 0.0) return rebuild(bed, m);
  }
  if (m.budget.inner >= 0.0) return true;
  for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b)
    bed.contacts.refresh(b, bed.bodies, spare_[m.index]);
  m.budget.inner = bed.contacts.fullBudget().inner;
  return true;
}

bool VelocityVerlet::rebuild(BedState& bed, Member& m) {
  bed.team.barrier();
  if (m.index == 0) sorted_ = bed.sort();
  bed.team.barrier();
  if (!sorted_) return false;
  for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b)
    bed.contacts.find(b, bed.bodies, spare_[m.index]);
  bed.team.barrier();
  if (m.index == 0) bed.contacts.link();
  bed.team.barrier();
  m.budget = bed.contacts.fullBudget();
  return true;
}

}  // namespace bedmix
