// SPDX-License-Identifier: MIT
#include "engine/dem/axis.h"
#include "engine/dem/integrators.h"

#include <utility>

namespace bedmix {

namespace {

/// Half a step in velocity, a whole one in position; `ahead` is the velocity after another half.
void driftAlong(Acceleration acceleration, double half, std::size_t n, double* __restrict x,
                double* __restrict v, double* __restrict ahead, const double* __restrict contacts,
                const double* __restrict others) {
  for (std::size_t i = 0; i < n; ++i) {
    const double dv = half * acceleration(contacts[i], others[i]);
    v[i] += dv;
    x[i] += v[i] * (2.0 * half);
    ahead[i] = v[i] + dv;
  }
}

/// Half a step in spin; `ahead` is the spin after another half.
void turn(double halfPerInertia, std::size_t n, double* __restrict spin, double* __restrict ahead,
          const double* __restrict torque) {
  for (std::size_t i = 0; i < n; ++i) {
    const double change = halfPerInertia * torque[i];
    spin[i] += change;
    ahead[i] = spin[i] + change;
  }
}

void kickAlong(Acceleration acceleration, double half, std::size_t n, double* __restrict v,
               const double* __restrict contacts, const double* __restrict others) {
  for (std::size_t i = 0; i < n; ++i) v[i] += half * acceleration(contacts[i], others[i]);
}

}  // namespace

template <bool friction>
VelocityVerlet<friction>::VelocityVerlet(const Scene& scene, std::size_t particles)
    : contacts_(scene), vx_(particles), vy_(particles), spin_(friction ? particles : 0) {}

template <bool friction>
void VelocityVerlet<friction>::begin(BedState& bed) {
  rebuild(bed);
  vx_ = bed.particles.vx;
  vy_ = bed.particles.vy;
  spin_ = bed.particles.spin;
  evaluate(bed, 0.0);
}

template <bool friction>
bool VelocityVerlet<friction>::step(BedState& bed) {
  LapTimer timer;
  const double distance = drift(bed);
  timer.lap(bed.seconds.integrate);
  const Particles& p = bed.particles;
  if (!bed.neighbours.spend(distance) && !bed.neighbours.measure(p.x, p.y) && !rebuild(bed)) return false;
  timer.lap(bed.seconds.neighbours);
  evaluate(bed, 0.5 * bed.step);
  timer.lap(bed.seconds.contacts);
  kick(bed);
  timer.lap(bed.seconds.integrate);
  return true;
}

// To the middle of the step in velocity, to its end in position. Returns the largest distance moved, m.
template <bool friction>
double VelocityVerlet<friction>::drift(BedState& bed) {
  Particles& p = bed.particles;
  const ContactLoads& loads = bed.loads;
  const double half = 0.5 * bed.step, perMass = 1.0 / p.mass;
  const std::size_t n = p.size();
  driftAlong({perMass, 0.0}, half, n, p.x.data(), p.vx.data(), vx_.data(), loads.fx.data(), p.fx.data());
  driftAlong({perMass, -bed.gravity}, half, n, p.y.data(), p.vy.data(), vy_.data(), loads.fy.data(),
             p.fy.data());
  if constexpr (friction) turn(half / p.inertia, n, p.spin.data(), spin_.data(), loads.torque.data());
  return largestNorm(p.vx, p.vy) * bed.step;
}

template <bool friction>
void VelocityVerlet<friction>::evaluate(BedState& bed, double halfStep) {
  const Particles& p = bed.particles;
  const Motion at{p.x.data(), p.y.data(), vx_.data(), vy_.data(), spin_.data()};
  contacts_.evaluate(at, bed.neighbours, bed.history, halfStep, next_, bed.loads);
  std::swap(bed.history, next_);
  next_.clear();
}

template <bool friction>
void VelocityVerlet<friction>::kick(BedState& bed) {
  Particles& p = bed.particles;
  const ContactLoads& loads = bed.loads;
  const double half = 0.5 * bed.step, perMass = 1.0 / p.mass;
  const std::size_t n = p.size();
  kickAlong({perMass, 0.0}, half, n, p.vx.data(), loads.fx.data(), p.fx.data());
  kickAlong({perMass, -bed.gravity}, half, n, p.vy.data(), loads.fy.data(), p.fy.data());
  // The next drift overwrites what this says of the spins ahead.
  if constexpr (friction) turn(half / p.inertia, n, p.spin.data(), spin_.data(), loads.torque.data());
}

template <bool friction>
bool VelocityVerlet<friction>::rebuild(BedState& bed) {
  if (!isFinite(bed.particles)) return false;
  bed.neighbours.build(bed.particles.x, bed.particles.y);
  bed.history.carryOver(bed.neighbours, next_);
  return true;
}

template class VelocityVerlet<false>;
template class VelocityVerlet<true>;

}  // namespace bedmix
