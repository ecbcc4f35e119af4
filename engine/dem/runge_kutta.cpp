// SPDX-License-Identifier: MIT
#include "engine/dem/integrators.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr std::array<double, 4> weights{1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
constexpr std::array<double, 4> instants{0.0, 0.5, 0.5, 1.0};  // of the stages, in steps

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
  for (std::size_t i = 0; i < p.size(); ++i) {
    sum_.x[i] += weight * at_.vx[i];
    sum_.y[i] += weight * at_.vy[i];
    sum_.vx[i] += weight * ((bed.loads.fx[i] + p.fx[i]) / p.mass);
    sum_.vy[i] += weight * ((bed.loads.fy[i] + p.fy[i]) / p.mass - bed.gravity);
    if constexpr (friction) sum_.spin[i] += weight * (bed.loads.torque[i] / p.inertia);
  }
}

// From the start of the step with the rates of the last stage. Returns the largest distance moved, m.
template <bool friction>
double RungeKutta4<friction>::moveFromStart(const BedState& bed, double duration) {
  const Particles& p = bed.particles;
  double fastest = 0.0;  // square
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double speed2 = at_.vx[i] * at_.vx[i] + at_.vy[i] * at_.vy[i];
    fastest = speed2 > fastest ? speed2 : fastest;
    at_.x[i] = p.x[i] + duration * at_.vx[i];
    at_.y[i] = p.y[i] + duration * at_.vy[i];
    at_.vx[i] = p.vx[i] + duration * ((bed.loads.fx[i] + p.fx[i]) / p.mass);
    at_.vy[i] = p.vy[i] + duration * ((bed.loads.fy[i] + p.fy[i]) / p.mass - bed.gravity);
    if constexpr (friction) at_.spin[i] = p.spin[i] + duration * (bed.loads.torque[i] / p.inertia);
  }
  return std::sqrt(fastest) * duration;
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
  double farthest = 0.0;  // square
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double dx = dt * sum_.x[i], dy = dt * sum_.y[i];
    const double distance2 = dx * dx + dy * dy;
    farthest = distance2 > farthest ? distance2 : farthest;
    p.x[i] += dx;
    p.y[i] += dy;
    p.vx[i] += dt * sum_.vx[i];
    p.vy[i] += dt * sum_.vy[i];
    if constexpr (friction) p.spin[i] += dt * sum_.spin[i];
  }

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
  return std::sqrt(farthest);
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
