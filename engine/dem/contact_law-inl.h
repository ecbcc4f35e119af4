// SPDX-License-Identifier: MIT

// The contact law, in vectors: once a target, in the manner of Highway.
#if defined(BEDMIX_DEM_CONTACT_LAW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef BEDMIX_DEM_CONTACT_LAW_INL_H_
#undef BEDMIX_DEM_CONTACT_LAW_INL_H_
#else
#define BEDMIX_DEM_CONTACT_LAW_INL_H_
#endif

#include "engine/dem/contact_kernel.h"
#include "engine/dem/kinematics-inl.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

/// What a vector of contacts adds to the first particles.
struct Push {
  V fx, fy, torque;
};

/// The part of the step around an instant for which two bodies touch, if they go on as they do, and the
/// means over the step.
struct Window {
  V share;    // of the step
  V overlap;  // m, counted as 0 while they do not touch
  V rate;     // m/s
};

inline constexpr double shortest = 1e-300;  // m; stands for a way of zero
inline constexpr double least = 1e-9;       // share that a sliding spring is set from

/// Of the force at an instant, or, with `onset`, of its mean over the step around it.
template <bool friction, bool onset>
class Law {
 public:
  explicit Law(const ContactKernel& kernel)
      : reach_(hn::Set(d_, kernel.law.reach)),
        reach2_(hn::Set(d_, kernel.law.reach * kernel.law.reach)),
        stiffness_(hn::Set(d_, kernel.law.stiffness)),
        damping_(hn::Set(d_, kernel.law.damping)),
        tangentialStiffness_(hn::Set(d_, kernel.law.tangentialStiffness)),
        perStiffness_(hn::Set(d_, friction ? 1.0 / kernel.law.tangentialStiffness : 0.0)),
        tangentialDamping_(hn::Set(d_, kernel.law.tangentialDamping)),
        friction_(hn::Set(d_, kernel.law.friction)),
        halfStep_(hn::Set(d_, kernel.halfStep)),
        pull_(hn::Set(d_, onset ? kernel.halfStep * kernel.law.stiffness / kernel.law.mass : 0.0)),
        tangentialPull_(hn::Set(
            d_, onset ? kernel.halfStep * kernel.law.tangentialStiffness / kernel.law.tangentialMass : 0.0)),
        radius_(hn::Set(d_, kernel.radius)),
        closest2_(reach2_) {}

  V radius() const { return radius_; }

  /// n points to the other, t = (-n_y, n_x): in the plane the tangential spring is one number and turns with
  /// the contact by itself. `apart` leads from the particle to the other, `velocity` is the other's relative
  /// to the particle, `rolling` the slip due to spin. Slip is the velocity of the particle's surface relative
  /// to the other's, along t. False, and no push, where none touches.
  HWY_INLINE bool apply(const Planar& apart, const Planar& velocity, V rolling, M among, std::size_t at,
                        const Tangential& t, Push& push) {
    const V distance2 = dot(apart, apart);
    const M touching = hn::And(among, hn::Lt(distance2, reach2_));
    M acting = touching;
    // Who gets within reach in half a step: (r + g)^2 < r^2 + 2 g (r + g), g = dt/2 |dot(v, n)|.
    if constexpr (onset)
      acting = hn::And(among, hn::Lt(distance2, hn::Add(reach2_, twoWays(hn::Abs(dot(apart, velocity))))));
    if (hn::AllFalse(d_, acting)) {
      if constexpr (friction) {
        hn::StoreU(hn::Zero(d_), d_, t.newSpring + at);
        hn::StoreU(hn::Zero(d_), d_, t.newSlip + at);
      }
      return false;
    }
    count_ += hn::CountTrue(d_, touching);
    closest2_ = hn::Min(closest2_, hn::IfThenElse(touching, distance2, reach2_));

    const V distance = hn::Sqrt(distance2);
    const V perDistance = hn::Div(hn::Set(d_, 1.0), distance);
    const V nx = hn::Mul(apart.x, perDistance), ny = hn::Mul(apart.y, perDistance);
    const V parting = dot(velocity, {nx, ny});
    const V overlap = hn::Sub(reach_, distance);
    Window window{};
    V normal;
    if constexpr (onset) {
      window = around(overlap, hn::Neg(parting));
      acting = hn::And(acting, hn::Gt(window.share, hn::Zero(d_)));
      normal =
          hn::Add(hn::Mul(stiffness_, window.overlap), hn::Mul(hn::Mul(damping_, window.share), window.rate));
    } else {
      normal = hn::Sub(hn::Mul(stiffness_, overlap), hn::Mul(damping_, parting));
    }
    V fx = hn::Neg(hn::Mul(normal, nx)), fy = hn::Neg(hn::Mul(normal, ny));
    push.torque = hn::Zero(d_);
    if constexpr (friction) {
      const V slip = hn::Add(hn::Sub(hn::Mul(velocity.x, ny), hn::Mul(velocity.y, nx)), rolling);
      const V limit = hn::Mul(friction_, hn::Abs(normal));
      const V force =
          onset ? rubInWindow(window, slip, limit, acting, at, t) : rub(slip, limit, acting, at, t);
      fx = hn::Sub(fx, hn::Mul(force, ny));
      fy = hn::Add(fy, hn::Mul(force, nx));
      push.torque = hn::IfThenElseZero(acting, hn::Mul(radius_, force));
    }
    push.fx = hn::IfThenElseZero(acting, fx);
    push.fy = hn::IfThenElseZero(acting, fy);
    return true;
  }

  KernelReport report() const { return {hn::GetLane(hn::MinOfLanes(d_, closest2_)), count_}; }

 private:
  HWY_INLINE V twoWays(V speed) const { return hn::Mul(hn::Add(halfStep_, halfStep_), speed); }

  /// `rate` is foreseen with the forces of the last step. Those of the contact's own spring, which began
  /// where the overlap was a step ago, are taken out of it, and put in again as they are now: else the
  /// dashpot lags behind.
  HWY_INLINE Window around(V overlap, V rate) const {
    const V zero = hn::Zero(d_);
    const V before = hn::Max(hn::Sub(overlap, twoWays(rate)), zero);
    const V free = hn::Add(rate, hn::Mul(pull_, before));
    const V way = hn::Mul(halfStep_, hn::Abs(free));
    const V inside = hn::Max(hn::Add(overlap, way), zero);
    const V share =
        hn::Min(hn::Div(inside, hn::Max(hn::Add(way, way), hn::Set(d_, shortest))), hn::Set(d_, 1.0));
    const V mean = hn::Max(overlap, hn::Mul(hn::Set(d_, 0.5), hn::Mul(inside, share)));
    return {share, mean, hn::Sub(free, hn::Mul(pull_, mean))};
  }

  HWY_INLINE V clamp(V force, V limit) const { return hn::Max(hn::Min(force, limit), hn::Neg(limit)); }

  HWY_INLINE V rub(V slip, V limit, M acting, std::size_t at, const Tangential& t) const {
    const V grown = hn::Mul(halfStep_, hn::Add(hn::LoadU(d_, t.slip + at), slip));
    const V spring = hn::Add(hn::LoadU(d_, t.spring + at), grown);
    const V stick =
        hn::Neg(hn::Add(hn::Mul(tangentialStiffness_, spring), hn::Mul(tangentialDamping_, slip)));
    const V force = clamp(stick, limit);
    // Unchanged where it sticks.
    const V left = hn::Add(spring, hn::Mul(hn::Sub(stick, force), perStiffness_));
    hn::StoreU(hn::IfThenElseZero(acting, left), d_, t.newSpring + at);
    hn::StoreU(hn::IfThenElseZero(acting, slip), d_, t.newSlip + at);
    return force;
  }

  /// The dashpot's slip is rid of its lag like the rate above. The spring grows only in the part of the
  /// window in which they touch, and ends with a contact that does. Stored is what it would be in the middle
  /// of the window if it had grown through all of it.
  HWY_INLINE V rubInWindow(const Window& window, V slip, V limit, M acting, std::size_t at,
                           const Tangential& t) const {
    const V way = hn::Mul(halfStep_, slip);
    const V first = hn::Add(hn::LoadU(d_, t.spring + at), hn::Mul(halfStep_, hn::LoadU(d_, t.slip + at)));
    const V grown = hn::Mul(window.share, way);
    const V mean = hn::Mul(window.share, hn::Add(first, grown));
    const V rate = hn::Add(slip, hn::Mul(tangentialPull_, hn::Sub(hn::LoadU(d_, t.spring + at), mean)));
    const V stick = hn::Neg(hn::Add(hn::Mul(tangentialStiffness_, mean),
                                    hn::Mul(hn::Mul(tangentialDamping_, window.share), rate)));
    const V force = clamp(stick, limit);
    const V last = hn::Add(first, hn::Sub(hn::Add(grown, grown), way));
    const V slid =
        hn::Div(hn::Mul(hn::Sub(stick, force), perStiffness_), hn::Max(window.share, hn::Set(d_, least)));
    const M goesOn = hn::Or(hn::Ge(window.share, hn::Set(d_, 1.0)), hn::Gt(window.rate, hn::Zero(d_)));
    const M kept = hn::And(acting, goesOn);
    hn::StoreU(hn::IfThenElseZero(kept, hn::Add(last, slid)), d_, t.newSpring + at);
    hn::StoreU(hn::IfThenElseZero(kept, slip), d_, t.newSlip + at);
    return force;
  }

  D d_;
  V reach_, reach2_, stiffness_, damping_, tangentialStiffness_, perStiffness_, tangentialDamping_, friction_;
  V halfStep_, pull_, tangentialPull_, radius_, closest2_;
  std::size_t count_ = 0;
};

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
