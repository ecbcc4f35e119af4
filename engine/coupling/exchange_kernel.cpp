// SPDX-License-Identifier: MIT
#include "engine/coupling/exchange_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/coupling/exchange_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "engine/coupling/locate-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

/// Two values next to each other: of points in a row, or of a vector in the plane.
using Pair = hn::FixedTag<double, 2>;
using PairOf = hn::Vec<Pair>;

HWY_INLINE PairOf between(PairOf lower, PairOf upper, PairOf shareOfUpper) {
  return lower + shareOfUpper * (upper - lower);
}

/// Two points of a row, between that row and the next.
HWY_INLINE PairOf betweenRows(const double* lower, std::int32_t stride, double shareOfUpper) {
  const Pair d;
  return between(hn::LoadU(d, lower), hn::LoadU(d, lower + stride), hn::Set(d, shareOfUpper));
}

/// Gas velocity at the i-th of a batch.
HWY_INLINE PairOf gasVelocity(const ExchangeKernel& k, std::int32_t stride, const ExchangeBatch& batch,
                              std::size_t i) {
  const Pair d;
  const BatchShares& shares = batch.shares;
  const PairOf upright =
      betweenRows(k.uprightVelocity + pointIndex(batch.inGrid.uprightFace[i]), stride, shares.upperCentre[i]);
  const PairOf level =
      betweenRows(k.levelVelocity + pointIndex(batch.inGrid.levelFace[i]), stride, shares.upperFace[i]);
  return between(hn::InterleaveLower(upright, level), hn::InterleaveUpper(d, upright, level),
                 hn::Load(d, shares.right + 2 * i));
}

/// Of the i-th of a batch that begins with particle `first`.
template <bool mixed, class D>
HWY_INLINE void storeShares(D d, const Sizes<mixed>& sizes, std::size_t first, const AxisPlace<D>& x,
                            const AxisPlace<D>& y, hn::Vec<D> coupled, std::size_t i, BatchShares& shares) {
  const auto perDiameter = sizes.perDiameter(d, first + i);
  hn::Store(volumeShare(d, perDiameter, x), d, shares.rightVolume + i);
  hn::Store(volumeShare(d, perDiameter, y), d, shares.upperVolume + i);
  storePairs(d, x.within, centreShare(d, x), shares.right + 2 * i);
  hn::Store(y.within, d, shares.upperFace + i);
  hn::Store(centreShare(d, y), d, shares.upperCentre + i);
  hn::Store(sizes.inVolumes(d, first + i, coupled * hn::Set(d, sizes.grid.particleVolume)), d,
            shares.coupledVolume + i);
}

/// Shares `given`, a coefficient and a source, out to four faces.
HWY_INLINE void deposit(PairOf given, PairOf right, PairOf upper, double* lowerFace, std::ptrdiff_t stride) {
  const Pair d;
  constexpr std::ptrdiff_t next = sizeof(FaceSums) / sizeof(double);
  const auto add = [d](double* to, PairOf what) HWY_ATTR { hn::StoreU(hn::LoadU(d, to) + what, d, to); };
  const PairOf toRight = given * right, toLeft = given - toRight;
  const PairOf toUpperRight = toRight * upper, toUpperLeft = toLeft * upper;
  double* const upperFace = lowerFace + next * stride;
  add(lowerFace, toLeft - toUpperLeft);
  add(lowerFace + next, toRight - toUpperRight);
  add(upperFace, toUpperLeft);
  add(upperFace + next, toUpperRight);
}

template <bool mixed>
void findSlipOf(const ExchangeKernel& kernel, Numbering sum, ExchangeBatch& batch) {
  const ExchangeKernel k = kernel;  // its own, so that no store can change it
  const Sizes<mixed> sizes{*k.grid, k.radii};
  const Numbering points{k.grid->stride, 0};
  locate(*k.grid, k.position + batch.begin, batch.size,
         [&](auto d, std::size_t i, auto x, auto y, auto coupled) HWY_ATTR {
           storeShares(d, sizes, batch.begin, x, y, coupled, i, batch.shares);
           storeIndices(d, points, x, y, i, batch.inGrid);
           storeIndices(d, sum, x, y, i, batch.inSum);
         });
  alignas(64) double velocity[2 * batchSize], voidage[2 * batchSize];  // of two cells side by side
  for (std::size_t i = 0; i < batch.size; ++i) {
    const Pair d;
    hn::Store(gasVelocity(k, points.stride, batch, i), d, velocity + 2 * i);
    const double* const cell = k.voidage + pointIndex(batch.inGrid.cell[i]);
    hn::Store(betweenRows(cell, points.stride, batch.shares.upperVolume[i]), d, voidage + 2 * i);
  }
  forVectors(batch.size, [&](auto d, std::size_t i) HWY_ATTR {
    const auto sides = loadPairs(d, voidage + 2 * i);
    hn::Store(sides.x + hn::Load(d, batch.shares.rightVolume + i) * (sides.y - sides.x), d,
              batch.voidage + i);
    const auto u = loadPairs(d, velocity + 2 * i), v = loadPlane(d, k.velocity + batch.begin + i);
    const auto alongX = u.x - v.x, alongY = u.y - v.y;
    auto slip = hn::Sqrt(alongX * alongX + alongY * alongY);
    if constexpr (mixed) slip = slip * sizes.ratio(d, batch.begin + i);
    hn::Store(slip, d, batch.slip + i);
  });
}

template <bool mixed>
void giveDragOf(const ExchangeKernel& kernel, const ExchangeBatch& batch, BlockSum<FaceSums>& sum) {
  const ExchangeKernel k = kernel;
  [[maybe_unused]] const Sizes<mixed> sizes{*k.grid, k.radii};
  alignas(64) double upright[2 * batchSize], level[2 * batchSize];  // coefficient and source
  forVectors(batch.size, [&](auto d, std::size_t i) HWY_ATTR {
    const std::size_t p = batch.begin + i;
    const auto at = loadPlane(d, k.position + p), v = loadPlane(d, k.velocity + p);
    const auto foreseen = loadPlane(d, k.foreseen + p);
    const auto step = hn::Set(d, k.gasStep);
    const auto owed = hn::LoadU(d, k.drag + p) * hn::Set(d, 1.0 / k.gasStep);
    auto drag = hn::Load(d, batch.shares.coupledVolume + i) * hn::Load(d, batch.drag + i);
    if constexpr (mixed) {
      const auto ratio = sizes.ratio(d, p);
      drag = drag / (ratio * ratio);
    }
    storePairs(d, drag, drag * v.x + owed * (at.x - foreseen.x), upright + 2 * i);
    storePairs(d, drag, drag * v.y + owed * (at.y - foreseen.y), level + 2 * i);
    hn::StoreU(drag, d, k.drag + p);
    storePairs(d, at.x + step * v.x, at.y + step * v.y, &k.foreseen[p].x);
  });
  const std::int32_t stride = sum.numbering().stride;
  FaceSums* const points = &sum[0];
  forDistant(batch.size, [&](std::size_t i) HWY_ATTR {
    const Pair d;
    const BatchShares& shares = batch.shares;
    deposit(hn::Load(d, upright + 2 * i), hn::Set(d, shares.right[2 * i]), hn::Set(d, shares.upperCentre[i]),
            &points[pointIndex(batch.inSum.uprightFace[i])].uprightCoefficient, stride);
    deposit(hn::Load(d, level + 2 * i), hn::Set(d, shares.right[2 * i + 1]), hn::Set(d, shares.upperFace[i]),
            &points[pointIndex(batch.inSum.levelFace[i])].levelCoefficient, stride);
  });
}

template <bool mixed>
void takeForcesOf(const ExchangeKernel& kernel, ExchangeBatch& batch) {
  const ExchangeKernel k = kernel;
  const Sizes<mixed> sizes{*k.grid, k.radii};
  const Numbering points{k.grid->stride, 0};
  locate(*k.grid, k.position + batch.begin, batch.size,
         [&](auto d, std::size_t i, auto x, auto y, auto coupled) HWY_ATTR {
           storeShares(d, sizes, batch.begin, x, y, coupled, i, batch.shares);
           storeIndices(d, points, x, y, i, batch.inGrid);
         });
  for (std::size_t i = 0; i < batch.size; ++i) {
    const Pair d;
    const PairOf right = hn::Set(d, batch.shares.rightVolume[i]),
                 upper = hn::Set(d, batch.shares.upperVolume[i]);
    const auto row = [&](const Vec2* cell) HWY_ATTR {
      return between(hn::LoadU(d, &cell[0].x), hn::LoadU(d, &cell[1].x), right);
    };
    const Vec2* const cell = k.pressureGradient + pointIndex(batch.inGrid.cell[i]);
    const PairOf gradient = between(row(cell), row(cell + points.stride), upper);
    const std::size_t p = batch.begin + i;
    const PairOf force = hn::Set(d, k.drag[p]) * gasVelocity(k, points.stride, batch, i) -
                         hn::Set(d, batch.shares.coupledVolume[i]) * gradient;
    hn::StoreU(force, d, &k.external[p].x);
  }
}

}  // namespace

void findSlip(const ExchangeKernel& kernel, Numbering sum, ExchangeBatch& batch) {
  (kernel.radii ? findSlipOf<true> : findSlipOf<false>)(kernel, sum, batch);
}
void giveDrag(const ExchangeKernel& kernel, const ExchangeBatch& batch, BlockSum<FaceSums>& sum) {
  (kernel.radii ? giveDragOf<true> : giveDragOf<false>)(kernel, batch, sum);
}
void takeForces(const ExchangeKernel& kernel, ExchangeBatch& batch) {
  (kernel.radii ? takeForcesOf<true> : takeForcesOf<false>)(kernel, batch);
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(findSlip);
HWY_EXPORT(giveDrag);
HWY_EXPORT(takeForces);

void ExchangeKernel::findSlip(Numbering sum, ExchangeBatch& batch) const {
  HWY_DYNAMIC_DISPATCH(findSlip)(*this, sum, batch);
}
void ExchangeKernel::giveDrag(const ExchangeBatch& batch, BlockSum<FaceSums>& sum) const {
  HWY_DYNAMIC_DISPATCH(giveDrag)(*this, batch, sum);
}
void ExchangeKernel::takeForces(ExchangeBatch& batch) const {
  HWY_DYNAMIC_DISPATCH(takeForces)(*this, batch);
}

}  // namespace bedmix
#endif
