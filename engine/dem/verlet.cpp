// SPDX-License-Identifier: MIT
#include "engine/dem/verlet.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

/// How contacts and motion share the time is looked at in one of so many steps: to ask the clock after each
/// stretch of particles takes time itself. A prime number, so that each step of a gas step gets its turn.
constexpr int sampledSteps = 13;

}  // namespace

Verlet::Verlet(const Scene& scene, const BedState& bed)
    : contacts_(scene),
      halves_(scene.time.integrator != Integrator::symplecticEuler),
      reachAhead_(scene.time.integrator == Integrator::verletOnset ? 2.0 : 0.0),
      spare_(bed.team.size()) {
  resize(bed);
}

void Verlet::resize(const BedState& bed) {
  fastest2_.resize(bed.contacts.blocks());
  deepest_.resize(bed.contacts.blocks());
  displacements_.resize(bed.contacts.blocks());
}

Verlet::Member Verlet::start(const BedState& bed, int index) const {
  return {.index = index, .blocks = bed.team.share(bed.contacts.blocks(), index), .budget = bed.budget};
}

// Null where there are none: the kernel leaves out what a scene does not use.
MotionKernel Verlet::motion(BedState& bed) const {
  Particles& p = bed.particles;
  const auto orNull = [](auto& values) { return values.empty() ? nullptr : values.data(); };
  return {.step = bed.step,
          .halves = halves_,
          .gravity = bed.gravity,
          .perMass = 1.0 / p.mass,
          .perInertia = 1.0 / p.inertia,
          .masses = p.inertial(),
          .radii = orNull(p.gyration.empty() ? p.radii : p.gyration),
          .body = bed.bodies.data(),
          .position = p.position.data(),
          .velocity = p.velocity.data(),
          .spin = orNull(p.spin),
          .external = orNull(p.external),
          .drag = orNull(p.drag),
          .loads = bed.loads.data(),
          .spinAhead = bed.spinAhead.data()};
}

void Verlet::begin(BedState& bed) {
  bed.placeBodies();
  bed.team.run([&](int index) {
    Member m = start(bed, index);
    rebuild(bed, m, 0.0);
    const Motion at = motionOf(bed, bed.timeAfter(0.0));
    for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b)
      contacts_.evaluate(bed, b, at, [](ContactSlots& slots, std::size_t) { return inPlace(slots); });
    bed.team.barrier();
    for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b) ContactForces::addIncoming(bed, b);
    if (index == 0) bed.budget = m.budget;
  });
}

// The coming step begins with the loads that ended the last one.
void Verlet::relist(BedState& bed) {
  const std::vector<Load> loads = bed.loads;
  if (!bed.sort()) return;
  resize(bed);
  bed.budget = bed.contacts.fullBudget(0.0);
  bed.team.run([&](int index) {
    const Range blocks = bed.team.share(bed.contacts.blocks(), index);
    for (std::size_t b = blocks.begin; b < blocks.end; ++b)
      bed.contacts.find(b, bed.budget.inner, bed.bodies, spare_[index]);
  });
  bed.contacts.link();
  const std::vector<std::int32_t>& order = bed.contacts.order();
  for (std::size_t k = 0; k < order.size(); ++k) bed.loads[k] = loads[order[k]];
}

StepOutcome Verlet::advance(BedState& bed, std::int64_t steps, double maxOverlap) {
  if (steps == 0) return {};
  contacts_.setStep(bed.step);
  StepOutcome outcome;
  bed.team.run([&](int index) {
    Member m = start(bed, index);
    walk(bed, m, steps, maxOverlap);
    if (index != 0) return;
    outcome = m.outcome;
    bed.budget = m.budget;
    m.lap(m.others);
    const double share = contactShare_ / std::max(contactShare_ + motionShare_, 1e-12);
    bed.seconds.neighbours += m.neighbours;
    bed.seconds.contacts += share * m.others;
    bed.seconds.integrate += (1.0 - share) * m.others;
  });
  stepsBefore_ += outcome.steps;
  bed.clockSteps += outcome.steps;
  for (const double v2 : fastest2_) outcome.finite &= std::isfinite(v2);
  if (outcome.steps < steps || !outcome.finite)
    for (std::size_t i = 0; i < bed.bodies.size(); ++i) bed.particles.position[i] = bed.bodies[i].position;
  return outcome;
}

// Particles are moved as soon as their contacts are through, while they are in the cache: contacts are all
// with who comes later in memory, and those have not moved yet. Only contacts that reach into the next
// member's blocks come before that.
void Verlet::walk(BedState& bed, Member& m, std::int64_t steps, double maxOverlap) {
  Motion at = motionOf(bed, bed.timeAfter(0.0));
  const auto addCrossing = [&](std::size_t b) {
    contacts_.addCrossing(bed, b, at, inPlace(bed.contacts.block(b).crossing));
  };
  const MotionKernel kernel = motion(bed);
  for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b)
    fastest2_[b] = kernel.drift(bed.contacts.block(b).particles);
  for (std::int64_t& taken = m.outcome.steps; taken < steps;) {
    bed.team.barrier();
    m.lap(m.others);
    m.sampled = m.index == 0 && (stepsBefore_ + taken) % sampledSteps == 0;
    if (taken > 0 && *std::max_element(deepest_.begin(), deepest_.end()) > maxOverlap) return;
    m.outcome.finite = keepLists(bed, m);
    m.lap(m.neighbours);
    if (!m.outcome.finite) return;

    const std::size_t inner =
        m.blocks.size() > bed.contacts.reach() ? m.blocks.end - bed.contacts.reach() : m.blocks.begin;
    for (std::size_t b = inner; b < m.blocks.end; ++b) addCrossing(b);
    bed.team.barrier();
    m.sample(nullptr);
    const bool last = ++taken == steps;
    at.time = bed.timeAfter(static_cast<double>(taken));
    for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b) {
      if (b < inner) addCrossing(b);
      contacts_.addWalls(bed, b, at);
      ContactForces::addIncoming(bed, b);
      fastest2_[b] = finish(bed, b, m, kernel, last);
      deepest_[b] = bed.contacts.block(b).deepest;
    }
  }
}

// The pairs of a block and the end of its particles' step. Returns the square of the largest speed.
double Verlet::finish(BedState& bed, std::size_t b, Member& m, const MotionKernel& kernel, bool last) {
  const Motion at = motionOf(bed, bed.timeAfter(0.0));
  ContactBlock& block = bed.contacts.block(b);
  const Tangential history = inPlace(block.near);
  double fastest2 = 0.0;
  Range slots, particles = block.particles;
  for (const std::size_t end : block.nearEnd) {
    slots = {slots.end, end};
    contacts_.addNear(bed, b, at, slots, history);
    m.sample(&contactShare_);
    particles.end = std::min(particles.begin + ContactBlock::stretch, block.particles.end);
    fastest2 = std::max(fastest2, last ? kernel.kick(particles) : kernel.kickAndDrift(particles));
    particles.begin = particles.end;
    m.sample(&motionShare_);
  }
  return fastest2;
}

// Every member comes to the same decisions, so that all meet as often.
bool Verlet::keepLists(BedState& bed, Member& m) {
  const double fastest2 = *std::max_element(fastest2_.begin(), fastest2_.end());
  if (!std::isfinite(fastest2)) return false;
  const double way = std::sqrt(fastest2) * bed.step, needed = reachAhead_ * way;
  m.budget.spend(way);
  if (m.budget.outer < needed) {
    for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b)
      displacements_[b] = bed.contacts.displacements(bed.contacts.block(b).particles, bed.bodies);
    bed.team.barrier();
    ContactList::Displacements all;
    for (const ContactList::Displacements& d : displacements_) all.add(d.largest), all.add(d.second);
    m.budget.outer = bed.contacts.remainder(all);
    if (m.budget.outer < needed) return rebuild(bed, m, way);
  }
  if (m.budget.inner >= needed) return true;
  m.budget.inner = bed.contacts.innerSkin(way);
  for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b)
    bed.contacts.refresh(b, m.budget.inner, bed.bodies, spare_[m.index]);
  return true;
}

bool Verlet::rebuild(BedState& bed, Member& m, double way) {
  bed.team.barrier();
  if (m.index == 0) sorted_ = bed.sort();
  bed.team.barrier();
  if (!sorted_) return false;
  m.budget = bed.contacts.fullBudget(way);
  for (std::size_t b = m.blocks.begin; b < m.blocks.end; ++b)
    bed.contacts.find(b, m.budget.inner, bed.bodies, spare_[m.index]);
  bed.team.barrier();
  if (m.index == 0) bed.contacts.link();
  bed.team.barrier();
  return true;
}

}  // namespace bedmix
