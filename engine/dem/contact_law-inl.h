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
#include "engine/dem/meeting-inl.h"
#include "engine/effects/cohesion-inl.h"
#include "engine/effects/rolling-inl.h"

#include <cstddef>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

/// What a contact law is composed of: tangential forces; the mean over the step instead of the instant; and
/// contacts with effects of their own, see ContactEffects. Which effects these are is asked at run time, the
/// same for all contacts: each question is foreseen, and a law for each set of effects would be compiled for
/// hours.
struct Parts {
  bool friction, onset, rich;
};

/// What a vector of contacts adds to the first particles. The second ones get the opposite forces, and the
/// same torque unless it is told.
struct Push {
  V fx, fy, torque, torqueOfSecond;
};

/// The springs and dashpots that act in a vector of contacts, of which a plain law has one for all.
struct Springs {
  V stiffness, damping, pull;
  V tangentialStiffness, perStiffness, tangentialDamping, tangentialPull;
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

/// What a rich law has beside its constants; a plain one has nothing.
template <bool rich>
struct LawEffects {
  LawEffects(const ContactKernel&, bool) {}
};
template <>
struct LawEffects<true> {
  LawEffects(const ContactKernel& kernel, bool atWall)
      : contact(*kernel.effects), rolling(kernel), attraction(kernel, atWall) {}

  const ContactEffects& contact;
  RollingTorque rolling;
  Attraction attraction;
};

/// Of the force at an instant, or, with `onset`, of its mean over the step around it.
template <Parts parts>
class Law {
  static constexpr bool friction = parts.friction, onset = parts.onset, rich = parts.rich;

 public:
  Law(const ContactKernel& kernel, bool atWall)
      : effects_(kernel, atWall),
        reach_(hn::Set(d_, kernel.law.reach)),
        reach2_(hn::Set(d_, kernel.law.reach * kernel.law.reach)),
        springs_{
            hn::Set(d_, kernel.law.stiffness),
            hn::Set(d_, kernel.law.damping),
            hn::Set(d_, onset ? kernel.halfStep * kernel.law.stiffness / kernel.law.mass : 0.0),
            hn::Set(d_, kernel.law.tangentialStiffness),
            hn::Set(d_, friction ? 1.0 / kernel.law.tangentialStiffness : 0.0),
            hn::Set(d_, kernel.law.tangentialDamping),
            hn::Set(d_, onset ? kernel.halfStep * kernel.law.tangentialStiffness / kernel.law.tangentialMass
                              : 0.0)},
        friction_(hn::Set(d_, kernel.law.friction)),
        halfStep_(hn::Set(d_, kernel.halfStep)),
        radius_(hn::Set(d_, kernel.radius)),
        closest2_(reach2_),
        deepest_(hn::Zero(d_)) {}

  V radius() const { return radius_; }

  /// n points to the other, t = (-n_y, n_x): in the plane the tangential spring is one number and turns with
  /// the contact by itself. `apart` leads from the particle to the other, `velocity` is the other's relative
  /// to the particle. Slip is the velocity of the particle's surface relative to the other's, along t. False,
  /// and no push, where none acts on another.
  HWY_INLINE bool apply(const Planar& apart, const Planar& velocity, const Meeting<rich>& meeting, M among,
                        std::size_t at, const Tangential& t, Push& push) {
    const V distance2 = dot(apart, apart);
    V reach = reach_, reach2 = reach2_;
    if constexpr (rich) {
      reach = meeting.reach;
      reach2 = hn::Mul(reach, reach);
    }
    const M touching = hn::And(among, hn::Lt(distance2, reach2));
    M acting = touching;
    // Who gets within reach in half a step: (r + g)^2 < r^2 + 2 g (r + g), g = dt/2 |dot(v, n)|.
    if constexpr (onset)
      acting = hn::And(among, hn::Lt(distance2, hn::Add(reach2, twoWays(hn::Abs(dot(apart, velocity))))));
    M any = acting, pulling = acting;
    V distance = distance2;
    if constexpr (rich) {
      if (effects_.attraction.isOn()) {
        distance = hn::Sqrt(distance2);
        pulling = effects_.attraction.reaches(hn::Sub(distance, reach), meeting.radius, among, at, t);
        any = hn::Or(acting, pulling);
      }
    }
    if (hn::AllFalse(d_, any)) {
      forget(at, t);
      return false;
    }
    count_ += hn::CountTrue(d_, touching);
    if constexpr (!rich) closest2_ = hn::Min(closest2_, hn::IfThenElse(touching, distance2, reach2));

    distance = hn::Sqrt(distance2);
    const V perDistance = hn::Div(hn::Set(d_, 1.0), distance);
    const V nx = hn::Mul(apart.x, perDistance), ny = hn::Mul(apart.y, perDistance);
    const V parting = dot(velocity, {nx, ny});
    const V overlap = hn::Sub(reach, distance);
    if constexpr (rich) deepest_ = hn::Max(deepest_, hn::IfThenElseZero(touching, overlap));
    Springs springs = springs_;
    if constexpr (rich) springs = springsOf(meeting, overlap);
    Window window{};
    V normal;
    if constexpr (onset) {
      window = around(overlap, hn::Neg(parting), springs.pull);
      acting = hn::And(acting, hn::Gt(window.share, hn::Zero(d_)));
      if constexpr (rich) springs = springsOf(meeting, window.overlap);
      normal = hn::Add(hn::Mul(springs.stiffness, window.overlap),
                       hn::Mul(hn::Mul(springs.damping, window.share), window.rate));
    } else {
      normal = hn::Sub(hn::Mul(springs.stiffness, overlap), hn::Mul(springs.damping, parting));
    }
    V towards = normal;  // what it pushes them apart with
    if constexpr (rich) {
      towards = hn::IfThenElseZero(acting, normal);
      if (effects_.attraction.isOn()) {
        const V pull = effects_.attraction.force(hn::Neg(overlap), distance, meeting.first, meeting.second,
                                                 meeting.radius);
        towards = hn::Sub(towards, hn::IfThenElseZero(pulling, pull));
      }
      any = hn::Or(acting, hn::And(any, pulling));
    } else {
      any = acting;
    }
    V fx = hn::Neg(hn::Mul(towards, nx)), fy = hn::Neg(hn::Mul(towards, ny));
    push.torque = hn::Zero(d_);
    if constexpr (rich) push.torqueOfSecond = push.torque;
    if constexpr (friction) {
      const V slip = hn::Add(hn::Sub(hn::Mul(velocity.x, ny), hn::Mul(velocity.y, nx)), meeting.rolling);
      const V limit = hn::Mul(coefficient(meeting), hn::Abs(normal));
      V force = onset ? rubInWindow(springs, window, slip, limit, acting, at, t)
                      : rub(springs, slip, limit, acting, at, t);
      if constexpr (rich) {
        force = hn::IfThenElseZero(acting, force);
        push.torque = hn::Mul(meeting.first, force);
        push.torqueOfSecond = hn::Mul(meeting.second, force);
        if (effects_.rolling.isOn()) {
          const V turn = effects_.rolling.torque(meeting.turning, normal, springs.stiffness, meeting.radius,
                                                 meeting.rollingInertia, acting, at, t);
          push.torque = hn::Add(push.torque, turn);
          push.torqueOfSecond = hn::Sub(push.torqueOfSecond, turn);
        }
      } else {
        push.torque = hn::IfThenElseZero(acting, hn::Mul(radius_, force));
      }
      fx = hn::Sub(fx, hn::Mul(force, ny));
      fy = hn::Add(fy, hn::Mul(force, nx));
    }
    push.fx = hn::IfThenElseZero(any, fx);
    push.fy = hn::IfThenElseZero(any, fy);
    return true;
  }

  KernelReport report() const {
    if constexpr (!rich) return {hn::GetLane(hn::MinOfLanes(d_, closest2_)), count_};
    const double left = hn::GetLane(reach_) - hn::GetLane(hn::MaxOfLanes(d_, deepest_));
    return {left * left, count_};
  }

 private:
  HWY_INLINE V twoWays(V speed) const { return hn::Mul(hn::Add(halfStep_, halfStep_), speed); }

  HWY_INLINE V coefficient(const Meeting<rich>& meeting) const {
    if constexpr (rich) return meeting.friction;
    return friction_;
  }

  /// Where none acts on another.
  HWY_INLINE void forget(std::size_t at, const Tangential& t) const {
    if constexpr (friction) {
      hn::StoreU(hn::Zero(d_), d_, t.newSpring + at);
      hn::StoreU(hn::Zero(d_), d_, t.newSlip + at);
    }
    if constexpr (rich) {
      effects_.rolling.forget(at, t);
      effects_.attraction.forget(at, t);
    }
  }

  /// At an overlap, which a Hertzian spring stiffens with.
  HWY_INLINE Springs springsOf(const Meeting<true>& m, V overlap) const {
    const ContactEffects& e = effects_.contact;
    Springs s;
    s.stiffness = hn::Set(d_, e.spring);
    if (e.hertz)
      s.stiffness = hn::Mul(s.stiffness, hn::Sqrt(hn::Mul(m.radius, hn::Max(overlap, hn::Zero(d_)))));
    s.damping = hn::Add(hn::Set(d_, e.dashpot), hn::Mul(m.damping, hn::Sqrt(hn::Mul(m.mass, s.stiffness))));
    s.pull = hn::Div(hn::Mul(halfStep_, s.stiffness), m.mass);
    s.tangentialStiffness = hn::Mul(hn::Set(d_, e.tangentialSpring), s.stiffness);
    s.perStiffness = hn::IfThenElseZero(hn::Gt(s.tangentialStiffness, hn::Zero(d_)),
                                        hn::Div(hn::Set(d_, 1.0), s.tangentialStiffness));
    s.tangentialDamping = hn::Mul(hn::Set(d_, e.tangentialDashpot), s.damping);
    s.tangentialPull = hn::Mul(hn::Set(d_, 3.5 * e.tangentialSpring), s.pull);  // 2/7 of the mass
    return s;
  }

  /// `rate` is foreseen with the forces of the last step. Those of the contact's own spring, which began
  /// where the overlap was a step ago, are taken out of it, and put in again as they are now: else the
  /// dashpot lags behind.
  HWY_INLINE Window around(V overlap, V rate, V pull) const {
    const V zero = hn::Zero(d_);
    const V before = hn::Max(hn::Sub(overlap, twoWays(rate)), zero);
    const V free = hn::Add(rate, hn::Mul(pull, before));
    const V way = hn::Mul(halfStep_, hn::Abs(free));
    const V inside = hn::Max(hn::Add(overlap, way), zero);
    const V share =
        hn::Min(hn::Div(inside, hn::Max(hn::Add(way, way), hn::Set(d_, shortest))), hn::Set(d_, 1.0));
    const V mean = hn::Max(overlap, hn::Mul(hn::Set(d_, 0.5), hn::Mul(inside, share)));
    return {share, mean, hn::Sub(free, hn::Mul(pull, mean))};
  }

  HWY_INLINE V clamp(V force, V limit) const { return hn::Max(hn::Min(force, limit), hn::Neg(limit)); }

  HWY_INLINE V rub(const Springs& s, V slip, V limit, M acting, std::size_t at, const Tangential& t) const {
    const V grown = hn::Mul(halfStep_, hn::Add(hn::LoadU(d_, t.slip + at), slip));
    const V spring = hn::Add(hn::LoadU(d_, t.spring + at), grown);
    const V stick =
        hn::Neg(hn::Add(hn::Mul(s.tangentialStiffness, spring), hn::Mul(s.tangentialDamping, slip)));
    const V force = clamp(stick, limit);
    // Unchanged where it sticks.
    const V left = hn::Add(spring, hn::Mul(hn::Sub(stick, force), s.perStiffness));
    hn::StoreU(hn::IfThenElseZero(acting, left), d_, t.newSpring + at);
    hn::StoreU(hn::IfThenElseZero(acting, slip), d_, t.newSlip + at);
    return force;
  }

  /// The dashpot's slip is rid of its lag like the rate above. The spring grows only in the part of the
  /// window in which they touch, and ends with a contact that does. Stored is what it would be in the middle
  /// of the window if it had grown through all of it.
  HWY_INLINE V rubInWindow(const Springs& s, const Window& window, V slip, V limit, M acting, std::size_t at,
                           const Tangential& t) const {
    const V way = hn::Mul(halfStep_, slip);
    const V first = hn::Add(hn::LoadU(d_, t.spring + at), hn::Mul(halfStep_, hn::LoadU(d_, t.slip + at)));
    const V grown = hn::Mul(window.share, way);
    const V mean = hn::Mul(window.share, hn::Add(first, grown));
    const V rate = hn::Add(slip, hn::Mul(s.tangentialPull, hn::Sub(hn::LoadU(d_, t.spring + at), mean)));
    const V stick = hn::Neg(hn::Add(hn::Mul(s.tangentialStiffness, mean),
                                    hn::Mul(hn::Mul(s.tangentialDamping, window.share), rate)));
    const V force = clamp(stick, limit);
    const V last = hn::Add(first, hn::Sub(hn::Add(grown, grown), way));
    const V slid =
        hn::Div(hn::Mul(hn::Sub(stick, force), s.perStiffness), hn::Max(window.share, hn::Set(d_, least)));
    const M goesOn = hn::Or(hn::Ge(window.share, hn::Set(d_, 1.0)), hn::Gt(window.rate, hn::Zero(d_)));
    const M kept = hn::And(acting, goesOn);
    hn::StoreU(hn::IfThenElseZero(kept, hn::Add(last, slid)), d_, t.newSpring + at);
    hn::StoreU(hn::IfThenElseZero(kept, slip), d_, t.newSlip + at);
    return force;
  }

  D d_;
  [[no_unique_address]] LawEffects<rich> effects_;
  V reach_, reach2_;
  Springs springs_;  // of a plain law
  V friction_, halfStep_, radius_, closest2_, deepest_;
  std::size_t count_ = 0;
};

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
