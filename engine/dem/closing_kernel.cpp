// SPDX-License-Identifier: MIT
#include "engine/dem/closing_kernel.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/dem/closing_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "engine/dem/kinematics-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

double hardest(const SpringDashpot& law, double span, const Body* body, const PairPlaces& pairs) {
  const D d;
  const double r2 = law.reach * law.reach;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0), half = hn::Set(d, 0.5);
  const V reach2 = hn::Set(d, r2), perReach2 = hn::Set(d, 1.0 / r2), within = hn::Set(d, 2.0 * span);
  const V spring2 = hn::Set(d, r2 * law.stiffness / law.mass);  // of an overlap of r, (m/s)2
  V largest = zero;
  const auto look = [&](auto&& at) HWY_ATTR {
    const auto [apart, velocity] = transpose([&](std::size_t l, std::size_t p) HWY_ATTR {
      return hn::Sub(part(body[pairs.second[at(l)]], p), part(body[pairs.first[at(l)]], p));
    });
    const V distance2 = dot(apart, apart), nearing = hn::Neg(dot(apart, velocity));
    // A gap g is closed in time where (r + g)^2 < r^2 + 2 span (r + g) closing, but for g^2.
    const V soon = hn::Max(hn::Mul(within, nearing), zero);
    const M counts = hn::Lt(distance2, hn::Add(reach2, soon));
    // No roots: with x = (r^2 - distance^2)/(2 r^2) the overlap is r (x + x^2/2), 1/distance^2 is
    // (1 + 2 x)/r^2.
    const V x = hn::Mul(half, hn::Sub(one, hn::Mul(distance2, perReach2)));
    const V overlap = hn::Max(hn::Add(x, hn::Mul(half, hn::Mul(x, x))), zero);
    const V closing2 = hn::Mul(hn::Mul(nearing, nearing), hn::Mul(perReach2, hn::Add(one, hn::Add(x, x))));
    const V impact2 = hn::Add(closing2, hn::Mul(spring2, hn::Mul(overlap, overlap)));
    largest = hn::Max(largest, hn::IfThenElseZero(counts, impact2));
  };
  std::size_t c = 0;
  for (; c + lanes <= pairs.count; c += lanes) look([&](std::size_t l) { return pairs.stride * (c + l); });
  // The last one again and again where there are no more.
  if (c < pairs.count) look([&](std::size_t l) { return pairs.stride * std::min(c + l, pairs.count - 1); });
  return hn::GetLane(hn::MaxOfLanes(d, largest));
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(hardest);

double hardestImpact2(const SpringDashpot& law, double span, const Body* body, const PairPlaces& pairs) {
  return HWY_DYNAMIC_DISPATCH(hardest)(law, span, body, pairs);
}

}  // namespace bedmix
#endif
