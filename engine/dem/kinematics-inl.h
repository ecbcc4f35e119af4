// SPDX-License-Identifier: MIT

// Places and velocities of some particles, in vectors: once a target, in the manner of Highway.
#if defined(BEDMIX_DEM_KINEMATICS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef BEDMIX_DEM_KINEMATICS_INL_H_
#undef BEDMIX_DEM_KINEMATICS_INL_H_
#else
#define BEDMIX_DEM_KINEMATICS_INL_H_
#endif

#include "engine/core/plane-inl.h"
#include "engine/dem/rows.h"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

/// Four contacts at a time even where vectors are longer: rows of four are what is loaded and stored.
using D = hn::CappedTag<double, 4>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
inline constexpr std::size_t lanes = hn::MaxLanes(D());

/// value(0), value(1), ...
template <class Tag, class Value>
HWY_INLINE hn::Vec<Tag> collect(Tag d, std::size_t first, Value&& value) {
  if constexpr (hn::MaxLanes(Tag()) == 2) {
    return hn::OddEven(hn::Set(d, value(first + 1)), hn::Set(d, value(first)));
  } else {
    const hn::Half<Tag> half;
    constexpr std::size_t upper = hn::MaxLanes(Tag()) / 2;
    return hn::Combine(d, collect(half, first + upper, value), collect(half, first, value));
  }
}

using Planar = Plane<D>;

/// Position and velocity of some particles, or of some relative to others.
struct Kinematics {
  Planar position, velocity;
};

/// row(l, part) are rows of bodies, or their halves where vectors are no longer.
template <class LoadRow>
HWY_INLINE Kinematics transpose(LoadRow&& row) {
  const D d;
  if constexpr (lanes == 4) {
    const V r0 = row(0, 0), r1 = row(1, 0), r2 = row(2, 0), r3 = row(3, 0);
    const V x01 = hn::InterleaveLower(d, r0, r1), y01 = hn::InterleaveUpper(d, r0, r1);
    const V x23 = hn::InterleaveLower(d, r2, r3), y23 = hn::InterleaveUpper(d, r2, r3);
    return {{hn::ConcatLowerLower(d, x23, x01), hn::ConcatLowerLower(d, y23, y01)},
            {hn::ConcatUpperUpper(d, x23, x01), hn::ConcatUpperUpper(d, y23, y01)}};
  } else {
    const V p0 = row(0, 0), p1 = row(1, 0), v0 = row(0, 1), v1 = row(1, 1);
    return {{hn::InterleaveLower(d, p0, p1), hn::InterleaveUpper(d, p0, p1)},
            {hn::InterleaveLower(d, v0, v1), hn::InterleaveUpper(d, v0, v1)}};
  }
}

HWY_INLINE V part(const Body& body, std::size_t p) { return hn::Load(D(), &body.position.x + p * lanes); }

HWY_INLINE Kinematics load(const Body* body, const std::int32_t* i) {
  return transpose([&](std::size_t l, std::size_t p) HWY_ATTR { return part(body[i[l]], p); });
}
HWY_INLINE Kinematics difference(const Body* body, const std::int32_t* i, const std::int32_t* j) {
  return transpose([&](std::size_t l, std::size_t p)
                       HWY_ATTR { return hn::Sub(part(body[j[l]], p), part(body[i[l]], p)); });
}

HWY_INLINE V dot(const Planar& a, const Planar& b) { return hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)); }

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
