// SPDX-License-Identifier: MIT
#include "engine/dem/integrators.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bedmix {

namespace {

/// What half a step changes a velocity by; `gravity` is the acceleration along the axis in hand.
struct HalfStep {
  double half;     // s
  double perMass;  // 1/kg
  double gravity;  // m/s2

  double change(double contacts, double others) const {
    return half * ((contacts + others) * perMass + gravity);
  }
};

// These are functions of pointers because g++ heeds __restrict best in arguments.

/// Half a step in velocity, a whole one in position; `ahead` is the velocity after another half.
void driftAlong(HalfStep step, std::size_t n, double* __restrict x, double* __restrict v,
                double* __restrict ahead, const double* __restrict contacts,
                const double* __restrict others) {
  const double dt = 2.0 * step.half;
  for (std::size_t i = 0; i < n; ++i) {
    const double dv = step.change(contacts[i], others[i]);
    v[i] += dv;
    x[i] += v[i] * dt;
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

void kickAlong(HalfStep step, std::size_t n, double* __restrict v, const double* __restrict contacts,
               const double* __restrict others) {
  for (std::size_t i = 0; i < n; ++i) v[i] += step.change(contacts[i], others[i]);
}

/// m/s. Four at a time: one maximum would wait for the other.
double largestSpeed(const std::vector<double>& vx, const std::vector<double>& vy) {
  constexpr std::size_t lanes = 4;
  double largest[lanes] = {};  // squares
  const std::size_t whole = vx.size() - vx.size() % lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
    for (std::size_t l = 0; l < lanes; ++l)
      largest[l] = std::max(largest[l], vx[i + l] * vx[i + l] + vy[i + l] * vy[i + l]);
  for (std::size_t i = whole; i < vx.size(); ++i)
    largest[0] = std::max(largest[0], vx[i] * vx[i] + vy[i] * vy[i]);
  return std::sqrt(std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3])));
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
  driftAlong({half, perMass, 0.0}, n, p.x.data(), p.vx.data(), vx_.data(), loads.fx.data(), p.fx.data());
  driftAlong({half, perMass, -bed.gravity}, n, p.y.data(), p.vy.data(), vy_.data(), loads.fy.data(),
             p.fy.data());
  if constexpr (friction) turn(half / p.inertia, n, p.spin.data(), spin_.data(), loads.torque.data());
  return largestSpeed(p.vx, p.vy) * bed.step;
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
  kickAlong({half, perMass, 0.0}, n, p.vx.data(), loads.fx.data(), p.fx.data());
  kickAlong({half, perMass, -bed.gravity}, n, p.vy.data(), loads.fy.data(), p.fy.data());
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
