// SPDX-License-Identifier: MIT

// Resistance to rolling, in vectors: once a target, in the manner of Highway.
#if defined(BEDMIX_EFFECTS_ROLLING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef BEDMIX_EFFECTS_ROLLING_INL_H_
#undef BEDMIX_EFFECTS_ROLLING_INL_H_
#else
#define BEDMIX_EFFECTS_ROLLING_INL_H_
#endif

#include "engine/dem/contact_kernel.h"
#include "engine/dem/kinematics-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

/// Ai, Chen, Rotter & Ooi (2011): types A, Eq. (4), and C, Eqs (9) to (16), whose spring is 2.25 k (mu_r
/// R)^2.
class RollingTorque {
 public:
  explicit RollingTorque(const ContactKernel& kernel)
      : isOn_(kernel.effects->rolling.has_value()),
        hasSpring_(isOn_ && kernel.effects->rolling->model == RollingModel::elasticPlastic),
        coefficient_(hn::Set(d_, isOn_ ? kernel.effects->rolling->coefficient : 0.0)),
        dampingRatio_(hn::Set(d_, isOn_ ? kernel.effects->rolling->dampingRatio : 0.0)),
        halfStep_(hn::Set(d_, kernel.halfStep)) {}

  bool isOn() const { return isOn_; }

  /// On the first of two, N m, whose spin is larger by `turning`, rad/s; the second gets the opposite.
  /// `normal` is the contact's force, N, `stiffness` its spring.
  HWY_INLINE V torque(V turning, V normal, V stiffness, V radius, V inertia, M acting, std::size_t at,
                      const Tangential& t) const {
    const V zero = hn::Zero(d_);
    const V arm = hn::Mul(coefficient_, radius);
    const V limit = hn::IfThenElseZero(acting, hn::Mul(arm, hn::Max(normal, zero)));
    if (!hasSpring_)
      return hn::IfThenElse(hn::Gt(turning, zero), hn::Neg(limit),
                            hn::IfThenElseZero(hn::Lt(turning, zero), limit));
    const V spring = hn::Mul(hn::Mul(hn::Set(d_, 2.25), stiffness), hn::Mul(arm, arm));
    const V grown = hn::Mul(halfStep_, hn::Add(hn::LoadU(d_, t.rollRate + at), turning));
    const V wanted = hn::Neg(hn::Mul(spring, hn::Add(hn::LoadU(d_, t.rolled + at), grown)));
    const V held = hn::Max(hn::Min(wanted, limit), hn::Neg(limit));
    const M isElastic = hn::Lt(hn::Abs(wanted), limit);
    const V critical = hn::Mul(hn::Set(d_, 2.0), hn::Sqrt(hn::Mul(inertia, spring)));
    const V dashpot = hn::Mul(hn::Mul(dampingRatio_, critical), turning);
    const M hasSpring = hn::And(acting, hn::Gt(spring, zero));
    hn::StoreU(hn::IfThenElseZero(hasSpring, hn::Neg(hn::Div(held, spring))), d_, t.rolled + at);
    hn::StoreU(hn::IfThenElseZero(acting, turning), d_, t.rollRate + at);
    return hn::IfThenElseZero(acting, hn::Sub(held, hn::IfThenElseZero(isElastic, dashpot)));
  }

  /// Where nothing touches.
  HWY_INLINE void forget(std::size_t at, const Tangential& t) const {
    if (!hasSpring_) return;
    hn::StoreU(hn::Zero(d_), d_, t.rolled + at);
    hn::StoreU(hn::Zero(d_), d_, t.rollRate + at);
  }

 private:
  D d_;
  bool isOn_, hasSpring_;
  V coefficient_, dampingRatio_, halfStep_;
};

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
