// SPDX-License-Identifier: MIT
#include "engine/coupling/drag_laws.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/coupling/drag_laws.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "engine/core/power-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

/// Tian et al. (2007), Eqs (3) and (4), divided by 1 - eps, for a vector of particles.
template <class D>
class Laws {
 public:
  using V = hn::Vec<D>;

  explicit Laws(const DragProperties& p)
      : inertial_(p.gasDensity / p.diameter),
        viscous_(p.viscosity / (p.diameter * p.diameter)),
        reynoldsPerSlip_(p.gasDensity * p.diameter / p.viscosity) {}

  /// Ergun (1952), Eq. (3a): 150 (1-eps) mu / (eps d^2) + 1.75 rho slip / d.
  HWY_INLINE V ergun(V voidage, V slip) const {
    return set(150.0 * viscous_) * (set(1.0) - voidage) / voidage + set(1.75 * inertial_) * slip;
  }

  /// Wen & Yu (1966), Eq. (3b) consistent with Eqs (2) and (9): 3/4 C_D Re mu / d^2 eps^-2.65,
  /// Re = rho eps d slip / mu.
  HWY_INLINE V wenYu(V voidage, V slip) const {
    const V reynolds = set(reynoldsPerSlip_) * voidage * slip;
    return set(0.75 * viscous_) * sphereDragTimesReynolds(reynolds) * power(d_, voidage, -2.65);
  }

  /// Either, by voidage; most particles of a bed are in the dense part, where no power is needed.
  HWY_INLINE V ergunWenYu(V voidage, V slip, bool printed) const {
    const V dense = ergun(voidage, slip);
    const auto isDense = voidage <= set(dilute);
    if (hn::AllTrue(d_, isDense)) return dense;
    const V consistent = wenYu(voidage, slip);
    return hn::IfThenElse(isDense, dense, printed ? consistent / voidage : consistent);
  }

 private:
  /// Eq. (4): C_D Re of a single sphere, finite at Re = 0.
  HWY_INLINE V sphereDragTimesReynolds(V reynolds) const {
    const V slow = set(24.0) + set(24.0 * 0.15) * power(d_, reynolds, 0.687);
    return hn::IfThenElse(reynolds < set(1000.0), slow, set(0.43) * reynolds);
  }

  static HWY_INLINE V set(double x) { return hn::Set(D(), x); }

  D d_;
  double inertial_, viscous_, reynoldsPerSlip_;
};

template <DragLaw law, class D>
HWY_INLINE hn::Vec<D> evaluate(const Laws<D>& laws, hn::Vec<D> voidage, hn::Vec<D> slip) {
  if constexpr (law == DragLaw::ergun) return laws.ergun(voidage, slip);
  if constexpr (law == DragLaw::wenYu) return laws.wenYu(voidage, slip);
  return laws.ergunWenYu(voidage, slip, law == DragLaw::ergunWenYuPrinted);
}

template <DragLaw law>
void evaluateAll(const DragProperties& properties, std::size_t n, const double* voidage, const double* slip,
                 double* drag) {
  const hn::ScalableTag<double> d;
  const hn::CappedTag<double, 1> single;
  const Laws<decltype(d)> laws(properties);
  const Laws<decltype(single)> lawsOfOne(properties);
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= n; i += hn::Lanes(d))
    hn::StoreU(evaluate<law>(laws, hn::LoadU(d, voidage + i), hn::LoadU(d, slip + i)), d, drag + i);
  for (; i < n; ++i)
    hn::StoreU(evaluate<law>(lawsOfOne, hn::LoadU(single, voidage + i), hn::LoadU(single, slip + i)), single,
               drag + i);
}

}  // namespace

void dragOf(DragLaw law, const DragProperties& properties, std::size_t n, const double* voidage,
            const double* slip, double* drag) {
  switch (law) {
    case DragLaw::ergunWenYu:
      return evaluateAll<DragLaw::ergunWenYu>(properties, n, voidage, slip, drag);
    case DragLaw::ergunWenYuPrinted:
      return evaluateAll<DragLaw::ergunWenYuPrinted>(properties, n, voidage, slip, drag);
    case DragLaw::ergun:
      return evaluateAll<DragLaw::ergun>(properties, n, voidage, slip, drag);
    case DragLaw::wenYu:
      return evaluateAll<DragLaw::wenYu>(properties, n, voidage, slip, drag);
  }
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(dragOf);

void evaluateDragLaw(DragLaw law, const DragProperties& properties, std::size_t n, const double* voidage,
                     const double* slip, double* drag) {
  HWY_DYNAMIC_DISPATCH(dragOf)(law, properties, n, voidage, slip, drag);
}

}  // namespace bedmix
#endif
