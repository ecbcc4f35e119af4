// SPDX-License-Identifier: MIT

// Drag laws in vectors: once a target, in the manner of Highway.
#if defined(BEDMIX_COUPLING_DRAG_LAWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef BEDMIX_COUPLING_DRAG_LAWS_INL_H_
#undef BEDMIX_COUPLING_DRAG_LAWS_INL_H_
#else
#define BEDMIX_COUPLING_DRAG_LAWS_INL_H_
#endif

#include "engine/core/power-inl.h"
#include "engine/coupling/drag_laws.h"

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

/// beta / (1 - eps) of a vector of particles. Where a law is known as a factor F on the drag of a single
/// slow sphere in the superficial velocity, 3 pi mu d eps slip F, that is 18 mu eps F / d^2. Re is
/// rho eps d slip / mu, but for Syamlal & O'Brien's.
template <class D>
class Laws {
 public:
  using V = hn::Vec<D>;

  explicit Laws(const DragProperties& p)
      : inertial_(p.gasDensity / p.diameter),
        viscous_(p.viscosity / (p.diameter * p.diameter)),
        reynoldsPerSlip_(p.gasDensity * p.diameter / p.viscosity) {}

  /// Ergun (1952), Tian et al. (2007), Eq. (3a): 150 (1-eps) mu / (eps d^2) + 1.75 rho slip / d.
  HWY_INLINE V ergun(V voidage, V slip) const {
    return set(150.0 * viscous_) * (set(1.0) - voidage) / voidage + set(1.75 * inertial_) * slip;
  }

  /// Wen & Yu (1966), Tian et al.'s Eq. (3b) consistent with Eqs (2) and (9): 3/4 C_D Re mu / d^2 eps^-2.65.
  HWY_INLINE V wenYu(V voidage, V slip, double fastCoefficient = 0.43) const {
    const V reynolds = reynoldsOf(voidage, slip);
    return set(0.75 * viscous_) * sphereDragTimesReynolds(reynolds, fastCoefficient) *
           power(d_, voidage, -2.65);
  }

  /// Either, by voidage; most particles of a bed are in the dense part, where no power is needed.
  HWY_INLINE V ergunWenYu(V voidage, V slip, bool printed) const {
    const V dense = ergun(voidage, slip);
    const auto isDense = voidage <= set(dilute);
    if (hn::AllTrue(d_, isDense)) return dense;
    const V consistent = wenYu(voidage, slip);
    return hn::IfThenElse(isDense, dense, printed ? consistent / voidage : consistent);
  }

  /// Gidaspow's (1994) pair, with C_D = 0.44 from Re 1000 on, blended as in Huilin & Gidaspow (2003), Eq.
  /// (26).
  HWY_INLINE V gidaspow(V voidage, V slip) const {
    const V share = arcTangent(set(150.0 * 1.75) * (voidage - set(dilute))) * set(1.0 / pi) + set(0.5);
    const V dense = ergun(voidage, slip);
    return dense + share * (wenYu(voidage, slip, 0.44) - dense);
  }

  /// Di Felice (1994): 3/4 C_D Re mu / d^2 eps^(1-chi), chi = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2 / 2), of
  /// Dallavalle's sphere.
  HWY_INLINE V diFelice(V voidage, V slip) const {
    const V reynolds = reynoldsOf(voidage, slip);
    const V beside = set(1.5) - set(log10Of2) * log2Of(d_, hn::Max(reynolds, set(1e-30)));
    const V exponent = set(-2.7) + set(0.65) * exp2Of(d_, set(-0.5 / ln2) * beside * beside);
    const V root = set(0.63) * hn::Sqrt(reynolds) + set(4.8);
    return set(0.75 * viscous_) * (root * root) * power(d_, voidage, exponent);
  }

  /// Hill, Koch & Ladd (2001) in the form of Koch & Hill (2001) that holds at any Re: 18 mu eps^2 / d^2 (F0 +
  /// F3 Re / 2).
  HWY_INLINE V kochHill(V voidage, V slip) const {
    const V solids = set(1.0) - voidage, square = voidage * voidage;
    const V logarithm = set(ln2) * log2Of(d_, hn::Max(solids, set(1e-30)));
    const V above = set(1.0) + set(3.0) * hn::Sqrt(set(0.5) * solids) +
                    set(135.0 / 64.0) * solids * logarithm + set(16.14) * solids;
    const V below = set(1.0) + solids * (set(0.681) + solids * (set(-8.48) + set(8.16) * solids));
    const V dense = set(10.0) * solids / (square * voidage);
    const V slow = hn::IfThenElse(solids < set(0.4), above / below, dense);
    const V fast = set(0.0673) + set(0.212) * solids + set(0.0232) / (square * square * voidage);
    return set(18.0 * viscous_) * square * (slow + set(0.5) * fast * reynoldsOf(voidage, slip));
  }

  /// Beetstra, van der Hoef & Kuipers (2007), Eq. (21), for spheres of one size.
  HWY_INLINE V beetstra(V voidage, V slip) const {
    const V one = set(1.0), solids = one - voidage, square = voidage * voidage;
    const V reynolds = reynoldsOf(voidage, slip);
    const V slow = set(10.0) * solids / square + square * (one + set(1.5) * hn::Sqrt(solids));
    const V fast = reynolds * (one / voidage + set(3.0) * solids * voidage) +
                   set(8.4) * power(d_, reynolds, 1.0 - 0.343);
    const V rise = power(d_, reynolds, set(0.5) + set(2.0) * solids);
    const V ten = exp2Of(d_, set(3.0 / log10Of2) * solids);
    return set(18.0 * viscous_) * voidage * (slow + set(0.413 / 24.0) / square * fast * rise / (rise + ten));
  }

  /// Syamlal & O'Brien (1987): 3/4 eps mu / d^2 (0.63 sqrt(Re) / V + 4.8 / sqrt(V))^2, Re = rho d slip / mu,
  /// where V, Garside & Al-Dibouni's (1977) velocity of settling over that of one sphere, belongs to Re.
  HWY_INLINE V syamlalOBrien(V voidage, V slip) const {
    const V reynolds = set(reynoldsPerSlip_) * slip, a = power(d_, voidage, 4.14);
    const V b =
        hn::IfThenElse(voidage <= set(0.85), set(0.8) * power(d_, voidage, 1.28), power(d_, voidage, 2.65));
    const V slower = a - set(0.06) * reynolds;
    const V size = hn::Abs(slower) + hn::Sqrt(slower * slower + set(0.24) * reynolds * b);
    const V v = hn::IfThenElse(slower < set(0.0), set(0.12) * reynolds * b / size, set(0.5) * size);
    const V root = set(0.63) * hn::Sqrt(reynolds) / v + set(4.8) / hn::Sqrt(v);
    return set(0.75 * viscous_) * voidage * (root * root);
  }

 private:
  static constexpr double pi = 3.14159265358979323846, ln2 = 0.693147180559945309417;
  static constexpr double log10Of2 = 0.301029995663981195214;

  HWY_INLINE V reynoldsOf(V voidage, V slip) const { return set(reynoldsPerSlip_) * voidage * slip; }

  /// Tian et al.'s Eq. (4): C_D Re of a single sphere, finite at Re = 0.
  HWY_INLINE V sphereDragTimesReynolds(V reynolds, double fastCoefficient) const {
    const V slow = set(24.0) + set(24.0 * 0.15) * power(d_, reynolds, 0.687);
    return hn::IfThenElse(reynolds < set(1000.0), slow, set(fastCoefficient) * reynolds);
  }

  /// The angle is halved three times by tan(a/2) = tan a / (1 + sqrt(1 + tan^2 a)); what remains is below
  /// pi/16, where the series falls by 25 a term.
  HWY_INLINE V arcTangent(V x) const {
    for (int halving = 0; halving < 3; ++halving) x = x / (set(1.0) + hn::Sqrt(set(1.0) + x * x));
    constexpr double c[]{1.0,        -1.0 / 3.0,  1.0 / 5.0,  -1.0 / 7.0,  1.0 / 9.0,  -1.0 / 11.0,
                         1.0 / 13.0, -1.0 / 15.0, 1.0 / 17.0, -1.0 / 19.0, 1.0 / 21.0, -1.0 / 23.0};
    return set(8.0) * x * polynomial(d_, x * x, c);
  }

  static HWY_INLINE V set(double x) { return hn::Set(D(), x); }

  D d_;
  double inertial_, viscous_, reynoldsPerSlip_;
};

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
