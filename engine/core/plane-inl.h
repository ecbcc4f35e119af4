// SPDX-License-Identifier: MIT

// Vectors of Vec2, for vector loops: once a target, in the manner of Highway.
#if defined(BEDMIX_CORE_PLANE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef BEDMIX_CORE_PLANE_INL_H_
#undef BEDMIX_CORE_PLANE_INL_H_
#else
#define BEDMIX_CORE_PLANE_INL_H_
#endif

#include "engine/core/vec2.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class D>
struct Plane {
  hn::Vec<D> x, y;
};

/// Pairs (x, y) one after the other.
template <class D>
HWY_INLINE Plane<D> loadPairs(D d, const double* from) {
  Plane<D> p;
  if constexpr (hn::MaxLanes(D()) == 1) {
    p = {hn::LoadU(d, from), hn::LoadU(d, from + 1)};
  } else {
    hn::LoadInterleaved2(d, from, p.x, p.y);
  }
  return p;
}

template <class D, class V>
HWY_INLINE void storePairs(D d, V a, V b, double* to) {
  if constexpr (hn::MaxLanes(D()) == 1) {
    hn::StoreU(a, d, to);
    hn::StoreU(b, d, to + 1);
  } else {
    hn::StoreInterleaved2(a, b, d, to);
  }
}

template <class D>
HWY_INLINE Plane<D> loadPlane(D d, const Vec2* from) {
  return loadPairs(d, &from->x);
}

template <class D>
HWY_INLINE void storePlane(D d, const Plane<D>& p, Vec2* to) {
  storePairs(d, p.x, p.y, &to->x);
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
