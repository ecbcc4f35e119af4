// SPDX-License-Identifier: MIT
#include "engine/dem/runge_kutta.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr std::array<double, 4> weights{1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
constexpr std::array<double, 4> instants{0.0, 0.5, 0.5, 1.0};  // of the stages, in steps

template <class T>
void add(std::vector<T>& to, double factor, const std::vector<T>& change) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * change[i];
}

template <class Values, class Of>
double largestNorm(const Values& values, Of&& of) {
  double largest = 0.0;
  for (const auto& value : values) largest = std::max(largest, dot(of(value), of(value)));
  return std::sqrt(largest);
}
double largestNorm(const std::vector<Vec2>& v) {
  return largestNorm(v, [](Vec2 u) { return u; });
}

/// visit(slots, k) for all arrays of contacts, k counting them in the order of evaluate().
template <class Visit>
void forSlots(BedState& bed, Visit&& visit) {
  std::size_t k = 0;
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b) {
    ContactBlock& block = bed.contacts.block(b);
    visit(block.crossing, k++);
    for (ContactBlock::AtWall& w : block.walls) visit(w.slots, k++);
    visit(block.near, k++);
  }
}

}  // namespace

RungeKutta4::RungeKutta4(const Scene& scene, const BedState& bed) : contacts_(scene) {
  sum_.position.resize(bed.particles.size());
  sum_.velocity.resize(bed.particles.size());
  sum_.spin.resize(bed.particles.spin.size());
  history_.resize(bed.contacts.blocks() * (2 + bed.contacts.walls().size()));
}

void RungeKutta4::begin(BedState& bed) {
  bed.placeBodies();
  rebuild(bed);
}

void RungeKutta4::relist(BedState& bed) {
  sum_.position.resize(bed.particles.size());
  sum_.velocity.resize(bed.particles.size());
  sum_.spin.resize(bed.particles.spin.size());
  if (!bed.sort()) return;
  history_.resize(bed.contacts.blocks() * (2 + bed.contacts.walls().size()));
  makeLists(bed);
}

StepOutcome RungeKutta4::advance(BedState& bed, std::int64_t steps, double maxOverlap) {
  StepOutcome outcome;
  for (; outcome.steps < steps && deepestOverlap(bed) <= maxOverlap; ++outcome.steps) {
    if (attempt(bed, false)) continue;
    LapTimer timer;
    outcome.finite = renewLists(bed);
    timer.lap(bed.seconds.neighbours);
    if (!outcome.finite) return outcome;
    attempt(bed, true);
  }
  outcome.finite = isFinite(bed.particles) && std::isfinite(largestNorm(bed.particles.velocity));
  return outcome;
}

bool RungeKutta4::attempt(BedState& bed, bool force) {
  LapTimer timer;
  bed.placeBodies();
  std::fill(sum_.position.begin(), sum_.position.end(), Vec2{});
  std::fill(sum_.velocity.begin(), sum_.velocity.end(), Vec2{});
  std::fill(sum_.spin.begin(), sum_.spin.end(), 0.0);

  for (std::size_t s = 0; s < 4; ++s) {
    if (s > 0) {
      const double duration = instants[s] * bed.step;
      const double distance = 2.0 * moveFromStart(bed, duration);
      if (!force && !(distance <= std::min(bed.budget.outer, bed.budget.inner))) return false;
      growSprings(s - 1, duration);
    }
    timer.lap(bed.seconds.integrate);
    evaluate(bed, s);
    timer.lap(bed.seconds.contacts);
    addRate(bed, weights[s]);
  }
  bed.budget.spend(finish(bed));
  ++bed.clockSteps;
  timer.lap(bed.seconds.integrate);
  return true;
}

void RungeKutta4::evaluate(BedState& bed, std::size_t stage) {
  std::fill(bed.loads.begin(), bed.loads.end(), Load{});
  const Motion at = motionOf(bed, bed.timeAfter(instants[stage]));
  std::size_t before = 0;  // arrays of earlier blocks
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b) {
    contacts_.evaluate(bed, b, at, [&](ContactSlots& slots, std::size_t k) -> Tangential {
      if (slots.spring.empty()) return {};
      History& h = history_[before + k];
      const double* const from = stage == 0 ? slots.spring.data() : h.trial.data();
      return {from, slots.slip.data(), (stage == 0 ? h.start : h.left).data(), h.slip[stage].data()};
    });
    before += 2 + bed.contacts.walls().size();
  }
  for (std::size_t b = 0; b < bed.contacts.blocks(); ++b) ContactForces::addIncoming(bed, b);
}

// `masses` are null where all are alike.
Vec2 RungeKutta4::acceleration(const BedState& bed, const double* masses, std::size_t i) const {
  const Particles& p = bed.particles;
  Vec2 force = bed.loads[i].force;
  if (!p.external.empty()) force += p.external[i] - p.drag[i] * bed.bodies[i].velocity;
  return 1.0 / (masses ? masses[i] : p.mass) * force - Vec2{0.0, bed.gravity};
}

void RungeKutta4::addRate(const BedState& bed, double weight) {
  const Particles& p = bed.particles;
  const double* const masses = p.inertial();
  for (std::size_t i = 0; i < p.size(); ++i) {
    sum_.position[i] += weight * bed.bodies[i].velocity;
    sum_.velocity[i] += weight * acceleration(bed, masses, i);
  }
  for (std::size_t i = 0; i < p.spin.size(); ++i)
    sum_.spin[i] += weight / p.inertiaOf(i) * bed.loads[i].torque;
}

// From the start of the step with the rates of the last stage. Returns the largest distance moved, m.
double RungeKutta4::moveFromStart(BedState& bed, double duration) {
  const Particles& p = bed.particles;
  const double* const masses = p.inertial();
  const double distance = duration * largestNorm(bed.bodies, [](const Body& b) { return b.velocity; });
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 gain = duration * acceleration(bed, masses, i);
    bed.bodies[i] = {p.position[i] + duration * bed.bodies[i].velocity, p.velocity[i] + gain};
  }
  for (std::size_t i = 0; i < p.spin.size(); ++i)
    bed.spinAhead[i] = p.spin[i] + duration / p.inertiaOf(i) * bed.loads[i].torque;
  return distance;
}

void RungeKutta4::growSprings(std::size_t stage, double duration) {
  for (History& h : history_)
    for (std::size_t c = 0; c < h.trial.size(); ++c) h.trial[c] = h.start[c] + duration * h.slip[stage][c];
}

// Who touches at the end of the step is whoever does in its last stage. Returns the largest distance moved,
// m.
double RungeKutta4::finish(BedState& bed) {
  Particles& p = bed.particles;
  const double dt = bed.step;
  add(p.position, dt, sum_.position);
  add(p.velocity, dt, sum_.velocity);
  add(p.spin, dt, sum_.spin);
  forSlots(bed, [&](ContactSlots& slots, std::size_t k) {
    if (slots.spring.empty()) return;
    const History& h = history_[k];
    for (std::size_t c = 0; c < slots.count; ++c) {
      const bool touches = h.left[c] != 0.0 || h.slip[3][c] != 0.0;
      double slip = 0.0;
      for (std::size_t s = 0; s < 4; ++s) slip += weights[s] * h.slip[s][c];
      slots.spring[c] = touches ? h.start[c] + dt * slip : 0.0;
      slots.slip[c] = h.slip[3][c];
    }
  });
  return dt * largestNorm(sum_.position);
}

bool RungeKutta4::renewLists(BedState& bed) {
  ContactList& lists = bed.contacts;
  bed.placeBodies();
  bed.budget.outer = lists.remainder(lists.displacements({0, bed.bodies.size()}, bed.bodies));
  const double way = bed.step * largestNorm(bed.particles.velocity);
  if (bed.budget.outer < 2.0 * way) return rebuild(bed);
  bed.budget.inner = lists.innerSkin(way);
  for (std::size_t b = 0; b < lists.blocks(); ++b) lists.refresh(b, bed.budget.inner, bed.bodies, spare_);
  fitHistory(bed);
  return true;
}

bool RungeKutta4::rebuild(BedState& bed) {
  if (!bed.sort()) return false;
  makeLists(bed);
  return true;
}

void RungeKutta4::makeLists(BedState& bed) {
  ContactList& lists = bed.contacts;
  bed.budget = lists.fullBudget(bed.step * largestNorm(bed.particles.velocity));
  for (std::size_t b = 0; b < lists.blocks(); ++b) lists.find(b, bed.budget.inner, bed.bodies, spare_);
  lists.link();
  fitHistory(bed);
}

void RungeKutta4::fitHistory(BedState& bed) {
  forSlots(bed, [&](ContactSlots& slots, std::size_t k) {
    History& h = history_[k];
    for (std::vector<double>* values :
         {&h.start, &h.trial, &h.left, &h.slip[0], &h.slip[1], &h.slip[2], &h.slip[3]})
      values->assign(slots.spring.size(), 0.0);
  });
}

}  // namespace bedmix
