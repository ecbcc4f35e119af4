// SPDX-License-Identifier: MIT

// Where particles lie on the grid, for vector loops: once a target, in the manner of Highway.
#if defined(BEDMIX_COUPLING_LOCATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef BEDMIX_COUPLING_LOCATE_INL_H_
#undef BEDMIX_COUPLING_LOCATE_INL_H_
#else
#define BEDMIX_COUPLING_LOCATE_INL_H_
#endif

#include "engine/core/plane-inl.h"
#include "engine/coupling/batch.h"
#include "engine/coupling/coupling_grid.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Calls body(d, i) for vectors of items from i on that together are all below n.
template <class Body>
HWY_INLINE void forVectors(std::size_t n, const Body& body) {
  const hn::ScalableTag<double> d;
  const hn::CappedTag<double, 1> single;
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= n; i += hn::Lanes(d)) body(d, i);
  for (; i < n; ++i) body(single, i);
}

/// A vector of places along one axis.
template <class D>
struct AxisPlace {
  hn::Vec<D> cell;
  hn::Vec<D> within;  // from its lower face, in cell sizes
  hn::Vec<D> upper;   // 1 in the upper half of the cell, else 0
  hn::Vec<D> size;    // m
  hn::Vec<D> slope;   // of the weights of the two nearest centres, per cell size
};

/// The nearest place in a grid of some size; its lower end for what is no number.
template <class D, class V>
HWY_INLINE V inside(D d, V at, V size) {
  return hn::IfThenElseZero(at > hn::Zero(d), hn::Min(at, size));
}

/// For places inside the grid.
template <class D, class V>
HWY_INLINE AxisPlace<D> findPlace(D d, const GridAxis& axis, V at) {
  const V one = hn::Set(d, 1.0);
  const GridAxis::Stretch* s = axis.stretches.data();
  const GridAxis::Stretch* const end = s + axis.stretches.size();
  V start = hn::Zero(d), perSize = hn::Set(d, s->perSize), first = start, last = hn::Set(d, s->lastCell);
  AxisPlace<D> place{start, start, start, hn::Set(d, s->size), one};
  while (++s != end) {
    const auto above = at >= hn::Set(d, s->start);
    start = hn::IfThenElse(above, hn::Set(d, s->start), start);
    first = hn::IfThenElse(above, hn::Set(d, s->firstCell), first);
    last = hn::IfThenElse(above, hn::Set(d, s->lastCell), last);
    perSize = hn::IfThenElse(above, hn::Set(d, s->perSize), perSize);
    place.size = hn::IfThenElse(above, hn::Set(d, s->size), place.size);
    place.slope = hn::IfThenElse(at >= hn::Set(d, s->fromCentre), hn::Set(d, s->slopeBelow), place.slope);
    place.slope = hn::IfThenElse(above, hn::Set(d, s->slopeAbove), place.slope);
    place.slope = hn::IfThenElse(at >= hn::Set(d, s->toCentre), one, place.slope);
  }
  const V cells = (at - start) * perSize, whole = hn::Min(hn::Floor(cells), last);
  place.cell = first + whole;
  place.within = cells - whole;
  place.upper = hn::IfThenElseZero(place.within >= hn::Set(d, 0.5), one);
  return place;
}

/// How large particles are: all alike or, with their radii, one by one.
template <bool mixed>
struct Sizes {
  const CouplingGrid& grid;
  const double* radii;

  /// Their diameters over that of the grid's particle.
  template <class D>
  HWY_INLINE hn::Vec<D> ratio(D d, std::size_t i) const {
    if constexpr (mixed) return hn::LoadU(d, radii + i) * hn::Set(d, 2.0 * grid.perDiameter);
    return hn::Set(d, 1.0);
  }
  template <class D>
  HWY_INLINE hn::Vec<D> perDiameter(D d, std::size_t i) const {
    if constexpr (mixed) return hn::Set(d, 0.5) / hn::LoadU(d, radii + i);
    return hn::Set(d, grid.perDiameter);
  }
  /// So many volumes of the grid's particle.
  template <class D>
  HWY_INLINE hn::Vec<D> inVolumes(D d, std::size_t i, hn::Vec<D> particles) const {
    if constexpr (!mixed) return particles;
    const auto r = ratio(d, i);
    return particles * (r * r * r);
  }
};

/// The share of a particle's volume that is in the upper one of the two nearest cells.
template <class D>
HWY_INLINE hn::Vec<D> volumeShare(D d, hn::Vec<D> perDiameter, const AxisPlace<D>& place) {
  const auto beyondFace = (place.within - place.upper) * place.size;
  const auto share = hn::Set(d, 0.5) + beyondFace * perDiameter;
  return hn::Max(hn::Zero(d), hn::Min(share, hn::Set(d, 1.0)));
}

/// The weight of the upper one of the two nearest centres.
template <class D>
HWY_INLINE hn::Vec<D> centreShare(D d, const AxisPlace<D>& place) {
  return (place.within - hn::Set(d, 0.5)) * place.slope + (hn::Set(d, 1.0) - place.upper);
}

/// Whole numbers up to 2^51 have their value in the last bits of a double when this is added.
inline constexpr double wholeBits = 0x1.8p52;

/// Bits of the number of the lower left one of the four nearest cells.
template <class D>
HWY_INLINE hn::Vec<D> cellIndex(D d, Numbering numbering, const AxisPlace<D>& x, const AxisPlace<D>& y) {
  return (y.cell + y.upper) * hn::Set(d, numbering.stride) + (x.cell + x.upper) +
         hn::Set(d, wholeBits - numbering.origin);
}

template <class D>
HWY_INLINE void storeIndices(D d, Numbering numbering, const AxisPlace<D>& x, const AxisPlace<D>& y,
                             std::size_t i, PointIndices& indices) {
  const auto cell = cellIndex(d, numbering, x, y);
  hn::Store(cell, d, indices.cell + i);
  hn::Store(cell - x.upper, d, indices.uprightFace + i);
  hn::Store(cell - y.upper * hn::Set(d, numbering.stride), d, indices.levelFace + i);
}

/// How much of a particle at height y is coupled.
template <class D, class V>
HWY_INLINE V coupledShare(D d, const CouplingGrid& grid, V y) {
  const V below = hn::Set(d, grid.taperShift) - y * hn::Set(d, grid.taperSlope);
  const V s = hn::Max(hn::Zero(d), hn::Min(below, hn::Set(d, 1.0)));
  return s * s * (hn::Set(d, 3.0) - (s + s));
}

/// Calls body(d, i, place along x, place along y, coupled share) for vectors of `n` particles.
template <class Body>
HWY_INLINE void locate(const CouplingGrid& grid, const Vec2* position, std::size_t n, const Body& body) {
  forVectors(n, [&](auto d, std::size_t i) HWY_ATTR {
    const auto at = loadPlane(d, position + i);
    const auto x = findPlace(d, grid.x, inside(d, at.x, hn::Set(d, grid.x.length)));
    const auto y = findPlace(d, grid.y, inside(d, at.y, hn::Set(d, grid.y.length)));
    body(d, i, x, y, coupledShare(d, grid, at.y));
  });
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
