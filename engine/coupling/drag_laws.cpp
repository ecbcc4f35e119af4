// SPDX-License-Identifier: MIT
#include "engine/coupling/drag_laws.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/coupling/drag_laws.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "engine/coupling/drag_laws-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

template <DragLaw law, class D>
HWY_INLINE hn::Vec<D> evaluate(const Laws<D>& laws, hn::Vec<D> voidage, hn::Vec<D> slip) {
  if constexpr (law == DragLaw::ergun) return laws.ergun(voidage, slip);
  if constexpr (law == DragLaw::wenYu) return laws.wenYu(voidage, slip);
  if constexpr (law == DragLaw::gidaspow) return laws.gidaspow(voidage, slip);
  if constexpr (law == DragLaw::diFelice) return laws.diFelice(voidage, slip);
  if constexpr (law == DragLaw::kochHill) return laws.kochHill(voidage, slip);
  if constexpr (law == DragLaw::beetstra) return laws.beetstra(voidage, slip);
  if constexpr (law == DragLaw::syamlalOBrien) return laws.syamlalOBrien(voidage, slip);
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
    case DragLaw::gidaspow:
      return evaluateAll<DragLaw::gidaspow>(properties, n, voidage, slip, drag);
    case DragLaw::diFelice:
      return evaluateAll<DragLaw::diFelice>(properties, n, voidage, slip, drag);
    case DragLaw::kochHill:
      return evaluateAll<DragLaw::kochHill>(properties, n, voidage, slip, drag);
    case DragLaw::beetstra:
      return evaluateAll<DragLaw::beetstra>(properties, n, voidage, slip, drag);
    case DragLaw::syamlalOBrien:
      return evaluateAll<DragLaw::syamlalOBrien>(properties, n, voidage, slip, drag);
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
