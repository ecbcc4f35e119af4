// SPDX-License-Identifier: MIT
#include "engine/effects/heat_laws.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/effects/heat_laws.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "engine/core/power-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

/// Calls body(d, i) for vectors of items from i on.
template <class Body>
HWY_INLINE void forLanes(std::size_t n, const Body& body) {
  const hn::ScalableTag<double> d;
  const hn::CappedTag<double, 1> single;
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= n; i += hn::Lanes(d)) body(d, i);
  for (; i < n; ++i) body(single, i);
}

double rootOf(double prandtl) {
  const hn::CappedTag<double, 1> d;
  return hn::GetLane(power(d, hn::Set(d, prandtl), 1.0 / 3.0));
}

/// With the cubic root of the Prandtl number.
template <class D, class V>
HWY_INLINE V nusseltOf(D d, double root, V voidage, V reynolds) {
  const auto set = [d](double x) HWY_ATTR { return hn::Set(d, x); };
  const V still = set(7.0) + voidage * (set(5.0) * voidage - set(10.0));
  const V moving = set(1.33) + voidage * (set(1.2) * voidage - set(2.4));
  const V log = log2Of(d, hn::Max(reynolds, set(1e-100)));
  const V first = exp2Of(d, log * set(0.2)), second = exp2Of(d, log * set(0.7));
  return still * (set(1.0) + set(0.7 * root) * first) + moving * set(root) * second;
}

/// 1 - e^-x for x >= 0.
template <class D, class V>
HWY_INLINE V relaxed(D d, V x) {
  constexpr double c[]{1.0,
                       1.0 / 2,
                       1.0 / 6,
                       1.0 / 24,
                       1.0 / 120,
                       1.0 / 720,
                       1.0 / 5040,
                       1.0 / 40320,
                       1.0 / 362880,
                       1.0 / 3628800,
                       1.0 / 39916800,
                       1.0 / 479001600,
                       1.0 / 6227020800.0,
                       1.0 / 87178291200.0};
  constexpr double perLn2 = 1.44269504088896340736;
  const V minus = hn::Zero(d) - x;
  const V much = hn::Set(d, 1.0) - exp2Of(d, hn::Max(minus * hn::Set(d, perLn2), hn::Set(d, -900.0)));
  return hn::IfThenElse(x < hn::Set(d, 0.5), x * polynomial(d, minus, c), much);
}

}  // namespace

void gunnOf(double prandtl, std::size_t n, const double* voidage, const double* reynolds, double* nusselt) {
  const double root = rootOf(prandtl);
  forLanes(n, [&](auto d, std::size_t i) HWY_ATTR {
    hn::StoreU(nusseltOf(d, root, hn::LoadU(d, voidage + i), hn::LoadU(d, reynolds + i)), d, nusselt + i);
  });
}

void convectionOf(const ConvectionLaw& law, double step, const ConvectionLaw::Batch& batch,
                  double* conductance) {
  const double root = rootOf(law.prandtl);
  forLanes(batch.size, [&](auto d, std::size_t i) HWY_ATTR {
    const auto eps = hn::LoadU(d, batch.voidage + i);
    const auto reynolds = hn::Set(d, law.reynoldsPerSlip) * eps * hn::LoadU(d, batch.slip + i);
    const auto whole =
        hn::Set(d, law.conductivity) * hn::LoadU(d, batch.length + i) * nusseltOf(d, root, eps, reynolds);
    const auto perStep = hn::LoadU(d, batch.heatCapacity + i) * hn::Set(d, 1.0 / step);
    hn::StoreU(relaxed(d, whole / perStep) * perStep, d, conductance + i);
  });
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(gunnOf);
HWY_EXPORT(convectionOf);

void gunnNusselt(double prandtl, std::size_t n, const double* voidage, const double* reynolds,
                 double* nusselt) {
  HWY_DYNAMIC_DISPATCH(gunnOf)(prandtl, n, voidage, reynolds, nusselt);
}

ConvectionLaw::ConvectionLaw(const Scene& scene) {
  const HeatGasSettings& gas = *scene.effects.find<HeatSettings>()->gas;
  prandtl = gas.heatCapacity * scene.gas->viscosity / gas.conductivity;
  reynoldsPerSlip = scene.gas->density * scene.particles.diameter / scene.gas->viscosity;
  conductivity = gas.conductivity;
}

void ConvectionLaw::conductances(double step, const Batch& batch, double* conductance) const {
  HWY_DYNAMIC_DISPATCH(convectionOf)(*this, step, batch, conductance);
}

ConductionLaw::ConductionLaw(const Scene& scene) {
  const HeatSettings& heat = *scene.effects.find<HeatSettings>();
  const auto& hertz = scene.contacts.hertz;
  conductivity = heat.conductivity;
  if (hertz) square = 1.0;
  if (!heat.youngsModulus) return;
  const double modulus = effectiveModulus({*heat.youngsModulus, heat.poissonRatio});
  if (hertz)
    square = std::cbrt(std::pow(effectiveModulus(*hertz) / modulus, 2));
  else
    cubePerArea = 3.0 * *scene.contacts.stiffness / (4.0 * modulus);
}

double ConductionLaw::contactRadius(double overlap, double reducedRadius) const {
  if (cubePerArea > 0.0) return std::cbrt(cubePerArea * overlap * reducedRadius);
  return std::sqrt(square * overlap * reducedRadius);
}

}  // namespace bedmix
#endif
