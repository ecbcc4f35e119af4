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
      displacements_(bed.contacts.blocks()) {}

VelocityVerlet::Member VelocityVerlet::start(const BedState& bed, int index) const {
  return {index, bed.team.share(bed.contacts.blocks(), index), bed.budget, {}, {}, {}};
}

// Null where there are none: the kernel leaves out what a scene does not use.
MotionKernel VelocityVerlet::motion(BedState& bed) const {
  Particles& p = bed.particles;
  const auto orNull = [](auto& values) { return values.empty() ? nullptr : values.data(); };
  return {bed.step,          bed.gravity,       1.0 / p.mass,     1.0 / p.inertia,
          p.position.data(), p.velocity.data(), orNull(p.spin),   orNull(p.external),
          orNull(p.drag),    bed.loads.data(),  bed.ahead.data(), bed.spinAhead.data()};
}

void VelocityVerlet::begin(BedState& bed) {
  bed.ahead = bed.particles.velocity;
  bed.spinAhead = bed.particles.spin;
  bed.team.run([&](int index) {
    Member m = start(bed, index);
    rebuild(bed, m);
    evaluate(bed, m, atStart_);
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
  if (outcome.finite)
    for (const double v2 : fastest2_) outcome.finite &= std::isfinite(v2);
  return outcome;
}

void VelocityVerlet::walk(BedState& bed, Member& m, std::int64_t steps, double maxOverlap) {
  const bool first = m.index == 0;
  for (std::int64_t& taken = m.outcome.steps; taken < steps && deepestOverlap(bed) <= maxOverlap; ++taken) {
    // The end of a step and the beginning of the next in one pass over memory.
    if (taken == 0)
      move(bed, m, &MotionKernel::drift, false);
    else
      move(bed, m, &MotionKernel::kickAndDrift, true);
    bed.team.barrier();
    if (first) m.timer.lap(m.seconds.integrate);
    m.outcome.finite = keepLists(bed, m);
    if (!m.outcome.finite) return;
    if (first) m.timer.lap(m.seconds.neighbours);
    evaluate(bed, m, contacts_);
    bed.team.barrier();
    if (first) m.timer.lap(m.seconds.contacts);
  }
  move(bed, m, &MotionKernel::kick, true);
  if (first) m.timer.lap(m.seconds.integrate);
}

void VelocityVerlet::move(BedState& bed, Member& m, double (MotionKernel::*how)(Range) const,
                          bool withIncoming) {
  const MotionKernel kernel = motion(bed);
  for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b) {
    if (withIncoming) ContactForces::addIncoming(bed, b);
    fastest2_[b] = (kernel.*how)(bed.contacts.block(b).particles);
  }
}

void VelocityVerlet::evaluate(BedState& bed, const Member& m, const ContactForces& contacts) {
  const Motion at{bed.particles.position.data(), bed.ahead.data(), bed.spinAhead.data()};
  for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b)
    contacts.evaluate(bed, b, at, [](ContactSlots& slots, std::size_t) { return inPlace(slots); });
}

// Every member comes to the same decisions, so that all meet as often.
bool VelocityVerlet::keepLists(BedState& bed, Member& m) {
  const double fastest2 = *std::max_element(fastest2_.begin(), fastest2_.end());
  if (!std::isfinite(fastest2)) return false;
  m.budget.spend(std::sqrt(fastest2) * bed.step);
  const std::vector<Vec2>& position = bed.particles.position;
  if (m.budget.outer < 0.0) {
    for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b)
      displacements_[b] = bed.contacts.displacements(bed.contacts.block(b).particles, position);
    bed.team.barrier();
    ContactList::Displacements all;
    for (const ContactList::Displacements& d : displacements_) all.add(d.largest), all.add(d.second);
    m.budget.outer = bed.contacts.remainder(all);
    if (m.budget.outer < 0.0) return rebuild(bed, m);
  }
  if (m.budget.inner >= 0.0) return true;
  for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b)
    bed.contacts.refresh(b, position, spare_[m.index]);
  m.budget.inner = bed.contacts.fullBudget().inner;
  return true;
}

bool VelocityVerlet::rebuild(BedState& bed, Member& m) {
  bed.team.barrier();
  if (m.index == 0) sorted_ = bed.sort();
  bed.team.barrier();
  if (!sorted_) return false;
  for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b)
    bed.contacts.find(b, bed.particles.position, spare_[m.index]);
  bed.team.barrier();
  if (m.index == 0) bed.contacts.link();
  m.budget = bed.contacts.fullBudget();
  return true;
}

}  // namespace bedmix
