// SPDX-License-Identifier: MIT
#include "engine/dem/integrators.h"

#include <cmath>
#include <utility>

namespace bedmix {

template <bool friction>
VelocityVerlet<friction>::VelocityVerlet(const Scene& scene, std::size_t particles)
    : contacts_(scene), vx_(particles), vy_(particles), spin_(friction ? particles : 0) {}

template <bool friction>
void VelocityVerlet<friction>::begin(BedState& bed) {
  rebuild(bed);
  vx_ = bed.particles.vx;
  vy_ = bed.particles.vy;
  spin_ = bed.particles.spin;
  evaluate(bed);
}

template <bool friction>
bool VelocityVerlet<friction>::step(BedState& bed) {
  LapTimer timer;
  const double distance = drift(bed);
  timer.lap(bed.seconds.integrate);
  const Particles& p = bed.particles;
  if (!bed.neighbours.spend(distance) && !bed.neighbours.measure(p.x, p.y) && !rebuild(bed)) return false;
  timer.lap(bed.seconds.neighbours);
  evaluate(bed);
  timer.lap(bed.seconds.contacts);
  kick(bed);
  timer.lap(bed.seconds.integrate);
  return true;
}

// To the middle of the step in velocity, to its end in position. Returns the largest distance moved, m.
template <bool friction>
double VelocityVerlet<friction>::drift(BedState& bed) {
  Particles& p = bed.particles;
  const std::size_t n = p.size();
  const double dt = bed.step, half = 0.5 * dt, perMass = 1.0 / p.mass, gravity = bed.gravity;
  double* __restrict x = p.x.data();
  double* __restrict y = p.y.data();
  double* __restrict vx = p.vx.data();
  double* __restrict vy = p.vy.data();
  double* __restrict aheadX = vx_.data();
  double* __restrict aheadY = vy_.data();
  const double* __restrict contactX = bed.loads.fx.data();
  const double* __restrict contactY = bed.loads.fy.data();
  const double* __restrict otherX = p.fx.data();
  const double* __restrict otherY = p.fy.data();

  double fastest = 0.0;  // square
  for (std::size_t i = 0; i < n; ++i) {
    const double dvx = half * ((contactX[i] + otherX[i]) * perMass);
    const double dvy = half * ((contactY[i] + otherY[i]) * perMass - gravity);
    vx[i] += dvx;
    vy[i] += dvy;
    x[i] += vx[i] * dt;
    y[i] += vy[i] * dt;
    aheadX[i] = vx[i] + dvx;
    aheadY[i] = vy[i] + dvy;
    const double speed2 = vx[i] * vx[i] + vy[i] * vy[i];
    fastest = speed2 > fastest ? speed2 : fastest;
  }
  if constexpr (friction) {
    const double turn = half / p.inertia;
    for (std::size_t i = 0; i < n; ++i) {
      const double dSpin = turn * bed.loads.torque[i];
      p.spin[i] += dSpin;
      spin_[i] = p.spin[i] + dSpin;
    }
  }
  return std::sqrt(fastest) * dt;
}

template <bool friction>
void VelocityVerlet<friction>::evaluate(BedState& bed) {
  const Particles& p = bed.particles;
  const Motion at{p.x.data(), p.y.data(), vx_.data(), vy_.data(), spin_.data()};
  contacts_.evaluate(at, bed.neighbours, bed.history, 0.5 * bed.step, next_, bed.loads);
  std::swap(bed.history, next_);
  next_.clear();
}

template <bool friction>
void VelocityVerlet<friction>::kick(BedState& bed) {
  Particles& p = bed.particles;
  const std::size_t n = p.size();
  const double half = 0.5 * bed.step, perMass = 1.0 / p.mass, gravity = bed.gravity;
  double* __restrict vx = p.vx.data();
  double* __restrict vy = p.vy.data();
  for (std::size_t i = 0; i < n; ++i) {
    vx[i] += half * ((bed.loads.fx[i] + p.fx[i]) * perMass);
    vy[i] += half * ((bed.loads.fy[i] + p.fy[i]) * perMass - gravity);
  }
  if constexpr (friction) {
    const double turn = half / p.inertia;
    double* __restrict spin = p.spin.data();
    for (std::size_t i = 0; i < n; ++i) spin[i] += turn * bed.loads.torque[i];
  }
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
