// SPDX-License-Identifier: MIT
#include "engine/dem/motion_kernel.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/dem/motion_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "engine/core/plane-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

/// A row of each of some particles.
template <class D>
struct Rows {
  hn::Vec<D> a, b, c, d;
};

template <class D>
HWY_INLINE Rows<D> loadRows(D d, const double* from) {
  Rows<D> r;
  if constexpr (hn::MaxLanes(D()) == 1) {
    r = {hn::LoadU(d, from), hn::LoadU(d, from + 1), hn::LoadU(d, from + 2), hn::LoadU(d, from + 3)};
  } else {
    hn::LoadInterleaved4(d, from, r.a, r.b, r.c, r.d);
  }
  return r;
}

template <class D>
HWY_INLINE void storeRows(D d, const Rows<D>& r, double* to) {
  if constexpr (hn::MaxLanes(D()) == 1) {
    hn::StoreU(r.a, d, to);
    hn::StoreU(r.b, d, to + 1);
    hn::StoreU(r.c, d, to + 2);
    hn::StoreU(r.d, d, to + 3);
  } else {
    hn::StoreInterleaved4(r.a, r.b, r.c, r.d, d, to);
  }
}

template <class D>
HWY_INLINE Plane<D> add(const Plane<D>& a, const Plane<D>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y)};
}

template <class D>
HWY_INLINE Plane<D> scale(hn::Vec<D> s, const Plane<D>& a) {
  return {hn::Mul(s, a.x), hn::Mul(s, a.y)};
}

/// What happens to a vector of particles; `halves` is velocity Verlet's.
template <bool mixed, bool turns, bool dragged, bool halves, bool kicks, bool drifts>
class Mover {
 public:
  explicit Mover(const MotionKernel& k) : k_(k) {}

  /// Those from `i` on, as many as D has lanes; the larger of `fastest2` and their squared speeds.
  template <class D>
  HWY_INLINE hn::Vec<D> move(D d, std::size_t i, hn::Vec<D> fastest2) const {
    const auto one = hn::Set(d, 1.0), part = hn::Set(d, kickOf()), zero = hn::Zero(d);
    const Rows<D> sums = loadRows(d, &k_.loads[i].force.x);
    Plane<D> force{sums.a, sums.b};
    auto braking = zero;  // drag/m in the part of a step that a kick is of
    if constexpr (dragged) {
      force = add(force, loadPlane(d, k_.external + i));
      braking = hn::Mul(hn::Mul(part, hn::LoadU(d, k_.drag + i)), perMass(d, i));
    }
    Plane<D> gain = scale<D>(perMass(d, i), force);
    gain.y = hn::Sub(gain.y, hn::Set(d, k_.gravity));
    gain = scale<D>(part, gain);
    Plane<D> v = loadPlane(d, k_.velocity + i);
    if constexpr (kicks) {
      if constexpr (dragged) v = scale<D>(hn::Sub(one, braking), v);
      v = add(v, gain);
    }
    if constexpr (drifts) {
      const Plane<D> start = v;
      v = add(v, gain);
      if constexpr (dragged) v = scale<D>(hn::Div(one, hn::Add(one, braking)), v);
      Plane<D> ahead = v;
      if constexpr (halves && dragged)
        ahead = {hn::Sub(hn::Add(v.x, v.x), start.x), hn::Sub(hn::Add(v.y, v.y), start.y)};
      else if constexpr (halves)
        ahead = add(v, gain);
      double* const body = &k_.body[i].position.x;
      const Rows<D> before = loadRows(d, body);
      const Plane<D> moved = add({before.a, before.b}, scale<D>(hn::Set(d, k_.step), v));
      storeRows(d, {moved.x, moved.y, ahead.x, ahead.y}, body);
      clear(d, i);
    } else {
      const Rows<D> body = loadRows(d, &k_.body[i].position.x);
      storePlane<D>(d, {body.a, body.b}, k_.position + i);
    }
    storePlane<D>(d, v, k_.velocity + i);
    if constexpr (turns) turn(d, i, sums.c);

    const auto speed2 = hn::Add(hn::Mul(v.x, v.x), hn::Mul(v.y, v.y));
    const auto huge = hn::Set(d, std::numeric_limits<double>::max());
    const auto infinite = hn::Set(d, std::numeric_limits<double>::infinity());
    return hn::Max(fastest2, hn::IfThenElse(hn::Le(speed2, huge), speed2, infinite));
  }

 private:
  double kickOf() const { return halves ? 0.5 * k_.step : k_.step; }

  template <class D>
  HWY_INLINE hn::Vec<D> perMass(D d, std::size_t i) const {
    if constexpr (mixed) return hn::Div(hn::Set(d, 1.0), hn::LoadU(d, k_.masses + i));
    return hn::Set(d, k_.perMass);
  }

  template <class D>
  HWY_INLINE void clear(D d, std::size_t i) const {
    double* const to = &k_.loads[i].force.x;
    for (std::size_t part = 0; part < 4; ++part) hn::StoreU(hn::Zero(d), d, to + part * hn::MaxLanes(d));
  }

  template <class D>
  HWY_INLINE void turn(D d, std::size_t i, hn::Vec<D> torque) const {
    auto gain = hn::Mul(hn::Set(d, kickOf() * k_.perInertia), torque);
    if constexpr (mixed) {
      const auto radius = hn::LoadU(d, k_.radii + i);
      gain = hn::Div(hn::Mul(hn::Set(d, 2.5 * kickOf()), hn::Mul(torque, perMass(d, i))),
                     hn::Mul(radius, radius));
    }
    auto spin = hn::LoadU(d, k_.spin + i);
    if constexpr (kicks) spin = hn::Add(spin, gain);
    if constexpr (drifts) {
      spin = hn::Add(spin, gain);
      hn::StoreU(halves ? hn::Add(spin, gain) : spin, d, k_.spinAhead + i);
    }
    hn::StoreU(spin, d, k_.spin + i);
  }

  MotionKernel k_;
};

template <bool mixed, bool turns, bool dragged, bool halves, bool kicks, bool drifts>
double moveAll(const MotionKernel& kernel, Range particles) {
  const Mover<mixed, turns, dragged, halves, kicks, drifts> mover(kernel);
  const hn::ScalableTag<double> d;
  const hn::CappedTag<double, 1> single;
  auto fastest2 = hn::Zero(d);
  std::size_t i = particles.begin;
  for (; i + hn::Lanes(d) <= particles.end; i += hn::Lanes(d)) fastest2 = mover.move(d, i, fastest2);
  auto last = hn::Set(single, hn::GetLane(hn::MaxOfLanes(d, fastest2)));
  for (; i < particles.end; ++i) last = mover.move(single, i, last);
  return hn::GetLane(last);
}

template <bool mixed, bool halves, bool kicks, bool drifts>
double choose(const MotionKernel& k, Range particles) {
  const bool dragged = k.external != nullptr;
  const auto smooth = dragged ? moveAll<mixed, false, true, halves, kicks, drifts>
                              : moveAll<mixed, false, false, halves, kicks, drifts>;
  const auto rough = dragged ? moveAll<mixed, true, true, halves, kicks, drifts>
                             : moveAll<mixed, true, false, halves, kicks, drifts>;
  return (k.spin != nullptr ? rough : smooth)(k, particles);
}
template <bool halves, bool kicks, bool drifts>
double choose(const MotionKernel& k, Range particles) {
  return k.masses ? choose<true, halves, kicks, drifts>(k, particles)
                  : choose<false, halves, kicks, drifts>(k, particles);
}

}  // namespace

double drift(const MotionKernel& k, Range particles) {
  return k.halves ? choose<true, false, true>(k, particles) : choose<false, false, true>(k, particles);
}
double kick(const MotionKernel& k, Range particles) {
  return k.halves ? choose<true, true, false>(k, particles) : choose<false, false, false>(k, particles);
}
double kickAndDrift(const MotionKernel& k, Range particles) {
  return k.halves ? choose<true, true, true>(k, particles) : choose<false, false, true>(k, particles);
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(drift);
HWY_EXPORT(kick);
HWY_EXPORT(kickAndDrift);

double MotionKernel::drift(Range particles) const { return HWY_DYNAMIC_DISPATCH(drift)(*this, particles); }
double MotionKernel::kick(Range particles) const { return HWY_DYNAMIC_DISPATCH(kick)(*this, particles); }
double MotionKernel::kickAndDrift(Range particles) const {
  return HWY_DYNAMIC_DISPATCH(kickAndDrift)(*this, particles);
}

}  // namespace bedmix
#endif
