// SPDX-License-Identifier: MIT

// Attraction between bodies, in vectors: once a target, in the manner of Highway.
#if defined(BEDMIX_EFFECTS_COHESION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef BEDMIX_EFFECTS_COHESION_INL_H_
#undef BEDMIX_EFFECTS_COHESION_INL_H_
#else
#define BEDMIX_EFFECTS_COHESION_INL_H_
#endif

#include "engine/core/power-inl.h"
#include "engine/dem/contact_kernel.h"
#include "engine/dem/kinematics-inl.h"

#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

/// See CohesionSettings for the laws.
class Attraction {
 public:
  Attraction(const ContactKernel& kernel, bool atWall)
      : effects_(*kernel.effects),
        bridge_(atWall ? effects_.wallBridge : effects_.pairBridge),
        atWall_(atWall),
        range_(hn::Set(d_, effects_.range)) {}

  bool isOn() const { return effects_.cohesion.has_value(); }

  /// Those that attract each other; bridges form and break.
  HWY_INLINE M reaches(V gap, V effectiveRadius, M among, std::size_t at, const Tangential& t) const {
    const M touching = hn::And(among, hn::Lt(gap, hn::Zero(d_)));
    if (effects_.cohesion->sjkr) return touching;
    if (effects_.cohesion->vanDerWaals) return hn::And(among, hn::Lt(gap, range_));
    const V wide = hn::Mul(hn::Set(d_, bridge_.rupture), bridgeRadius(effectiveRadius));
    const M before = hn::Gt(hn::LoadU(d_, t.bridge + at), hn::Zero(d_));
    const M bridged = hn::And(hn::And(among, hn::Or(before, touching)), hn::Lt(gap, wide));
    hn::StoreU(hn::IfThenElseZero(bridged, hn::Set(d_, 1.0)), d_, t.bridge + at);
    return bridged;
  }

  /// N; of `distance` between the centres, or of a centre from the wall, m, with the radii of both, m.
  HWY_INLINE V force(V gap, V distance, V first, V second, V effectiveRadius) const {
    const V zero = hn::Zero(d_);
    if (const auto& law = effects_.cohesion->vanDerWaals) {
      const V near = hn::Max(gap, hn::Set(d_, law->leastGap));
      return hn::Div(hn::Mul(hn::Set(d_, law->hamaker / 6.0), effectiveRadius), hn::Mul(near, near));
    }
    if (const auto& law = effects_.cohesion->liquidBridge) {
      const V radius = bridgeRadius(effectiveRadius);
      const V open = hn::Div(hn::Max(gap, zero), radius);
      const V exponent = hn::Add(hn::Mul(hn::Set(d_, bridge_.a), open), hn::Set(d_, bridge_.b));
      const V power =
          exp2Of(d_, hn::Mul(hn::Max(exponent, hn::Set(d_, -600.0)), hn::Set(d_, std::numbers::log2e)));
      return hn::Mul(hn::Mul(hn::Set(d_, std::numbers::pi * law->surfaceTension), radius),
                     hn::Add(power, hn::Set(d_, bridge_.c)));
    }
    // Where the spheres' surfaces cut each other.
    const V first2 = hn::Mul(first, first), distance2 = hn::Mul(distance, distance);
    V arm = distance;  // of that circle from the first centre
    if (!atWall_)
      arm =
          hn::Div(hn::Add(distance2, hn::Sub(first2, hn::Mul(second, second))), hn::Add(distance, distance));
    const V area = hn::Mul(hn::Set(d_, std::numbers::pi), hn::Max(hn::Sub(first2, hn::Mul(arm, arm)), zero));
    return hn::Mul(hn::Set(d_, effects_.cohesion->sjkr->energyDensity), area);
  }

  /// Where nothing is near.
  HWY_INLINE void forget(std::size_t at, const Tangential& t) const {
    if (t.bridge) hn::StoreU(hn::Zero(d_), d_, t.bridge + at);
  }

 private:
  /// Of a pair the one of two equal spheres of the same effective radius.
  HWY_INLINE V bridgeRadius(V effectiveRadius) const {
    return atWall_ ? effectiveRadius : hn::Add(effectiveRadius, effectiveRadius);
  }

  D d_;
  const ContactEffects& effects_;
  const BridgeLaw& bridge_;
  bool atWall_;
  V range_;
};

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
