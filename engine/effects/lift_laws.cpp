// SPDX-License-Identifier: MIT
#include "engine/effects/lift_laws.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/effects/lift_laws.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "engine/core/power-inl.h"

#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

constexpr double least = 1e-100;  // a Reynolds number, to divide by

/// Of the particle's and the shear's Reynolds numbers.
template <class D, class V>
HWY_INLINE V meiFactor(D d, V reynolds, V shear) {
  const V one = hn::Set(d, 1.0);
  const V reached = hn::Set(d, 0.3314) * hn::Sqrt(hn::Set(d, 0.5) * shear / reynolds);
  constexpr double perLn2 = 1.44269504088896340736;
  const V faded = exp2Of(d, hn::Max(reynolds * hn::Set(d, -0.1 * perLn2), hn::Set(d, -900.0)));
  const V slow = faded + reached * (one - faded);
  const V fast = hn::Set(d, 0.0524) * hn::Sqrt(hn::Set(d, 0.5) * shear);
  return hn::IfThenElse(reynolds <= hn::Set(d, 40.0), slow, fast);
}

template <class D, class V>
HWY_INLINE V lunLiuFactor(D d, V reynolds) {
  const V fast = hn::Set(d, 0.178) + hn::Set(d, 0.822) * power(d, reynolds, -0.522);
  return hn::IfThenElse(reynolds <= hn::Set(d, 1.0), hn::Set(d, 1.0), fast);
}

/// The larger of the two, which meet at Re_s = 31.7.
template <class D, class V>
HWY_INLINE V dennisFactor(D d, V reynolds) {
  constexpr double part = 1.0 / (64.0 * std::numbers::pi);
  const V fast = hn::Set(d, 12.9 * part) * hn::Sqrt(reynolds) + hn::Set(d, 128.4 * part);
  return hn::Max(hn::Set(d, 1.0), fast);
}

template <class D>
HWY_INLINE void evaluateVector(D d, const LiftLaw& law, const LiftLaw::Batch& batch, std::size_t i,
                               double* lift, double* resistance) {
  const auto diameter = hn::LoadU(d, batch.diameter + i), vorticity = hn::LoadU(d, batch.vorticity + i);
  const auto perViscosity = hn::Set(d, law.density / law.viscosity), square = diameter * diameter;
  const auto reynolds = hn::Max(perViscosity * diameter * hn::LoadU(d, batch.slip + i), hn::Set(d, least));
  auto sum = hn::Zero(d);
  if (law.models.shear != ShearLift::none) {
    const auto turning = hn::Abs(vorticity);
    auto size = hn::Set(d, 1.615) * square * hn::Sqrt(hn::Set(d, law.density * law.viscosity) * turning);
    if (law.models.shear == ShearLift::mei)
      size = size * meiFactor(d, reynolds, perViscosity * square * turning);
    sum = hn::CopySign(size, vorticity);
  }
  auto held = hn::Zero(d);
  if (law.models.spin != SpinLift::none) {
    const auto relative = hn::LoadU(d, batch.spin + i) - hn::Set(d, 0.5) * vorticity;
    const auto cube = hn::Set(d, std::numbers::pi) * square * diameter;
    auto driven = hn::Set(d, 0.125 * law.density) * cube * relative;
    held = hn::Set(d, law.viscosity) * cube;
    if (law.models.spin == SpinLift::lunLiu) {
      driven = driven * lunLiuFactor(d, reynolds);
      held = held * dennisFactor(d, perViscosity * square * hn::Abs(relative));
    }
    sum = sum + driven;
  }
  hn::StoreU(sum, d, lift + i);
  hn::StoreU(held, d, resistance + i);
}

}  // namespace

void evaluateLift(const LiftLaw& law, const LiftLaw::Batch& batch, double* lift, double* resistance) {
  const hn::ScalableTag<double> d;
  const hn::CappedTag<double, 1> single;
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= batch.size; i += hn::Lanes(d))
    evaluateVector(d, law, batch, i, lift, resistance);
  for (; i < batch.size; ++i) evaluateVector(single, law, batch, i, lift, resistance);
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(evaluateLift);

void LiftLaw::evaluate(const Batch& batch, double* lift, double* resistance) const {
  HWY_DYNAMIC_DISPATCH(evaluateLift)(*this, batch, lift, resistance);
}

}  // namespace bedmix
#endif
