// SPDX-License-Identifier: MIT
#include "engine/coupling/point_box.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/coupling/point_box.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "engine/coupling/locate-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

/// The outermost of the places inside a grid of some size, lane by lane.
template <class D>
struct Reach {
  hn::Vec<D> size, least, most;

  HWY_INLINE void include(D d, hn::Vec<D> anywhere) {
    const auto at = inside(d, anywhere, size);
    least = hn::Min(least, at);
    most = hn::Max(most, at);
  }
};

/// The cell a place is in.
std::int32_t cellAt(const GridAxis& axis, double at) {
  const hn::CappedTag<double, 1> d;
  return static_cast<std::int32_t>(hn::GetLane(findPlace(d, axis, hn::Set(d, at)).cell));
}

}  // namespace

PointBox reachOf(const CouplingGrid& grid, std::span<const Vec2> particles) {
  // x in even, y in odd lanes.
  const hn::FixedTag<double, 2> pair;
  const hn::ScalableTag<double> d;
  alignas(16) const double lengths[]{grid.x.length, grid.y.length};
  const double* at = &particles.front().x;
  const double* const end = at + 2 * particles.size();
  Reach<decltype(d)> reach{hn::LoadDup128(d, lengths), hn::LoadDup128(d, lengths), hn::Zero(d)};
  for (; at + hn::Lanes(d) <= end; at += hn::Lanes(d)) reach.include(d, hn::LoadU(d, at));
  Reach<decltype(pair)> last{hn::Load(pair, lengths), hn::Load(pair, lengths), hn::Zero(pair)};
  alignas(64) double least[hn::MaxLanes(d)], most[hn::MaxLanes(d)];
  hn::Store(reach.least, d, least);
  hn::Store(reach.most, d, most);
  for (std::size_t k = 0; k < hn::Lanes(d); k += 2) {
    last.include(pair, hn::Load(pair, least + k));
    last.include(pair, hn::Load(pair, most + k));
  }
  for (; at != end; at += 2) last.include(pair, hn::LoadU(pair, at));
  hn::Store(last.least, pair, least);
  hn::Store(last.most, pair, most);

  // From a cell's lower face to the centre of the cell above it.
  const std::int32_t column = cellAt(grid.x, least[0]), row = cellAt(grid.y, least[1]);
  return {column, row, cellAt(grid.x, most[0]) + 3 - column, cellAt(grid.y, most[1]) + 3 - row};
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(reachOf);

PointBox boxAround(const CouplingGrid& grid, std::span<const Vec2> particles) {
  if (particles.empty()) return {};
  return HWY_DYNAMIC_DISPATCH(reachOf)(grid, particles);
}

}  // namespace bedmix
#endif
