// SPDX-License-Identifier: MIT
#include "engine/dem/axis.h"
#include "engine/dem/integrators.h"

#include <algorithm>

namespace bedmix {

namespace {

constexpr std::array<double, 4> weights{1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
constexpr std::array<double, 4> instants{0.0, 0.5, 0.5, 1.0};  // of the stages, in steps

void addRateAlong(Acceleration acceleration, double weight, std::size_t n, double* __restrict sumX,
                  double* __restrict sumV, const double* __restrict v, const double* __restrict contacts,
                  const double* __restrict others) {
  for (std::size_t i = 0; i < n; ++i) {
    sumX[i] += weight * v[i];
    sumV[i] += weight * acceleration(contacts[i], others[i]);
  }
}

/// `x0` and `v0` are the start of the step, `v` is the last stage's and becomes the next one's.
void moveAlong(Acceleration acceleration, double duration, std::size_t n, double* __restrict x,
               double* __restrict v, const double* __restrict x0, const double* __restrict v0,
               const double* __restrict contacts, const double* __restrict others) {
  for (std::size_t i = 0; i < n; ++i) {
    x[i] = x0[i] + duration * v[i];
    v[i] = v0[i] + duration * acceleration(contacts[i], others[i]);
  }
}

/// to += factor * change.
void add(std::vector<double>& to, double factor, const std::vector<double>& change) {
  double* __restrict values = to.data();
  for (std::size_t i = 0; i < to.size(); ++i) values[i] += factor * change[i];
}

}  // namespace

template <bool friction>
RungeKutta4<friction>::RungeKutta4(const Scene& scene, std::size_t particles) : contacts_(scene) {
  for (Values* v : {&at_, &sum_}) {
    for (std::vector<double>* a : {&v->x, &v->y, &v->vx, &v->vy}) a->resize(particles);
    if (friction) v->spin.resize(particles);
  }
}

template <bool friction>
void RungeKutta4<friction>::begin(BedState& bed) {
  rebuild(bed);
}

template <bool friction>
bool RungeKutta4<friction>::step(BedState& bed) {
  if (attempt(bed, false)) return true;
  LapTimer timer;
  const bool stillGood = bed.neighbours.measure(bed.particles.x, bed.particles.y);
  timer.lap(bed.seconds.neighbours);
  if (stillGood && attempt(bed, false)) return true;
  LapTimer rebuilding;
  if (!rebuild(bed)) return false;
  rebuilding.lap(bed.seconds.neighbours);
  return attempt(bed, true);
}

template <bool friction>
bool RungeKutta4<friction>::attempt(BedState& bed, bool force) {
  LapTimer timer;
  const Particles& p = bed.particles;
  at_.x = p.x;
  at_.y = p.y;
  at_.vx = p.vx;
  at_.vy = p.vy;
  at_.spin = p.spin;
  for (std::vector<double>* s : {&sum_.x, &sum_.y, &sum_.vx, &sum_.vy, &sum_.spin})
    std::fill(s->begin(), s->end(), 0.0);
  for (ContactHistory& stage : stages_) stage.clear();

  for (std::size_t s = 0; s < 4; ++s) {
    if (s > 0) {
      const double duration = instants[s] * bed.step;
      const double distance = moveFromStart(bed, duration);
      if (!force && !bed.neighbours.covers(distance)) return false;
      growSprings(stages_[s - 1], duration);
    }
    timer.lap(bed.seconds.integrate);
    const Motion at{at_.x.data(), at_.y.data(), at_.vx.data(), at_.vy.data(), at_.spin.data()};
    contacts_.evaluate(at, bed.neighbours, s == 0 ? bed.history : trial_, 0.0, stages_[s], bed.loads);
    timer.lap(bed.seconds.contacts);
    addRate(bed, weights[s]);
  }
  bed.neighbours.spend(finish(bed));
  timer.lap(bed.seconds.integrate);
  return true;
}

template <bool friction>
void RungeKutta4<friction>::addRate(const BedState& bed, double weight) {
  const Particles& p = bed.particles;
  const std::size_t n = p.size();
  const double perMass = 1.0 / p.mass;
  addRateAlong({perMass, 0.0}, weight, n, sum_.x.data(), sum_.vx.data(), at_.vx.data(), bed.loads.fx.data(),
               p.fx.data());
  addRateAlong({perMass, -bed.gravity}, weight, n, sum_.y.data(), sum_.vy.data(), at_.vy.data(),
               bed.loads.fy.data(), p.fy.data());
  if constexpr (friction) add(sum_.spin, weight / p.inertia, bed.loads.torque);
}

// From the start of the step with the rates of the last stage. Returns the largest distance moved, m.
template <bool friction>
double RungeKutta4<friction>::moveFromStart(const BedState& bed, double duration) {
  const Particles& p = bed.particles;
  const std::size_t n = p.size();
  const double perMass = 1.0 / p.mass, distance = duration * largestNorm(at_.vx, at_.vy);
  moveAlong({perMass, 0.0}, duration, n, at_.x.data(), at_.vx.data(), p.x.data(), p.vx.data(),
            bed.loads.fx.data(), p.fx.data());
  moveAlong({perMass, -bed.gravity}, duration, n, at_.y.data(), at_.vy.data(), p.y.data(), p.vy.data(),
            bed.loads.fy.data(), p.fy.data());
  if constexpr (friction) {
    at_.spin = p.spin;
    add(at_.spin, duration / p.inertia, bed.loads.torque);
  }
  return distance;
}

template <bool friction>
void RungeKutta4<friction>::growSprings(const ContactHistory& before, double duration) {
  for (std::size_t k = 0; k < trial_.spring.size(); ++k)
    trial_.spring[k] = stages_[0].spring[k] + duration * before.slip[k];
}

// Who touches at the end of the step is whoever does in its last stage. Returns the largest distance moved,
// m.
template <bool friction>
double RungeKutta4<friction>::finish(BedState& bed) {
  Particles& p = bed.particles;
  const double dt = bed.step;
  add(p.x, dt, sum_.x);
  add(p.y, dt, sum_.y);
  add(p.vx, dt, sum_.vx);
  add(p.vy, dt, sum_.vy);
  if constexpr (friction) add(p.spin, dt, sum_.spin);

  ContactHistory& history = bed.history;
  const ContactHistory& last = stages_[3];
  history.clear();
  history.pairCount = last.pairCount;
  history.count = last.count;
  for (std::size_t c = 0; c < last.count; ++c) {
    const std::int32_t k = history.touching[c] = last.touching[c];
    if constexpr (friction) {
      double slip = 0.0;
      for (std::size_t s = 0; s < 4; ++s) slip += weights[s] * stages_[s].slip[k];
      history.spring[k] = stages_[0].spring[k] + dt * slip;
    }
  }
  return dt * largestNorm(sum_.x, sum_.y);
}

template <bool friction>
bool RungeKutta4<friction>::rebuild(BedState& bed) {
  if (!isFinite(bed.particles)) return false;
  bed.neighbours.build(bed.particles.x, bed.particles.y);
  bed.history.carryOver(bed.neighbours, trial_);
  for (ContactHistory& stage : stages_) stage.reset(bed.neighbours.size(), friction);
  return true;
}

template class RungeKutta4<false>;
template class RungeKutta4<true>;

}  // namespace bedmix
