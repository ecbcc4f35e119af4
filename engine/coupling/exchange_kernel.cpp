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
HWY_INLINE PairOf gasVelocity(const CouplingGrid& grid, const GasAtPoints& gas, const PointIndices& at,
                              const BatchShares& shares, std::size_t i) {
  const Pair d;
  const PairOf upright =
      betweenRows(&gas.uprightVelocity[pointIndex(at.uprightFace[i])], grid.stride, shares.y.centre[i]);
  const PairOf level =
      betweenRows(&gas.levelVelocity[pointIndex(at.levelFace[i])], grid.stride, shares.y.face[i]);
  const PairOf shareOfRight =
      hn::InterleaveLower(hn::Set(d, shares.x.face[i]), hn::Set(d, shares.x.centre[i]));
  return between(hn::InterleaveLower(upright, level), hn::InterleaveUpper(d, upright, level), shareOfRight);
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

}  // namespace

void findSlip(const CouplingGrid& grid, const GasAtPoints& gas, const std::vector<double>& voidage,
              const Particles& particles, Numbering sum, ExchangeBatch& batch) {
  BatchShares& shares = batch.shares;
  PointIndices at;
  alignas(64) double velocity[2 * batchSize], voidages[2 * batchSize];
  locate(grid, &particles.position[batch.begin], batch.size, shares,
         [&](auto d, std::size_t i, const auto& x, const auto& y) HWY_ATTR {
           storeIndices(d, {grid.stride, 0}, x, y, i, at);
           storeIndices(d, sum, x, y, i, batch.gave);
         });
  for (std::size_t i = 0; i < batch.size; ++i) {
    const Pair d;
    hn::Store(gasVelocity(grid, gas, at, shares, i), d, velocity + 2 * i);
    hn::Store(betweenRows(&voidage[pointIndex(at.cell[i])], grid.stride, shares.y.volume[i]), d,
              voidages + 2 * i);
  }
  forVectors(batch.size, [&](auto d, std::size_t i) HWY_ATTR {
    const auto row = loadPairs(d, voidages + 2 * i);
    hn::Store(row.x + hn::Load(d, shares.x.volume + i) * (row.y - row.x), d, batch.voidage + i);
    const auto u = loadPairs(d, velocity + 2 * i), v = loadPlane(d, &particles.velocity[batch.begin + i]);
    const auto x = u.x - v.x, y = u.y - v.y;
    hn::Store(hn::Sqrt(x * x + y * y), d, batch.slip + i);
  });
}

void giveDrag(const CouplingGrid& grid, double gasStep, const ExchangeBatch& batch, Particles& particles,
              BlockSum<FaceSums>& sum) {
  alignas(64) double upright[2 * batchSize], level[2 * batchSize];  // coefficient and source
  const BatchShares& shares = batch.shares;
  forVectors(batch.size, [&](auto d, std::size_t i) HWY_ATTR {
    const std::size_t p = batch.begin + i;
    const auto at = loadPlane(d, &particles.position[p]), v = loadPlane(d, &particles.velocity[p]);
    const auto foreseen = loadPlane(d, &particles.foreseen[p]);
    const auto step = hn::Set(d, gasStep);
    const auto owed = hn::LoadU(d, &particles.drag[p]) * hn::Set(d, 1.0 / gasStep);
    const auto volume = hn::Load(d, shares.coupled + i) * hn::Set(d, grid.particleVolume);
    const auto drag = volume * hn::Load(d, batch.drag + i);
    storePairs(d, drag, drag * v.x + owed * (at.x - foreseen.x), upright + 2 * i);
    storePairs(d, drag, drag * v.y + owed * (at.y - foreseen.y), level + 2 * i);
    hn::StoreU(drag, d, &particles.drag[p]);
    storePairs(d, at.x + step * v.x, at.y + step * v.y, &particles.foreseen[p].x);
  });
  const std::int32_t stride = sum.numbering().stride;
  for (std::size_t i = 0; i < batch.size; ++i) {
    const Pair d;
    deposit(hn::Load(d, upright + 2 * i), hn::Set(d, shares.x.face[i]), hn::Set(d, shares.y.centre[i]),
            &sum[pointIndex(batch.gave.uprightFace[i])].uprightCoefficient, stride);
    deposit(hn::Load(d, level + 2 * i), hn::Set(d, shares.x.centre[i]), hn::Set(d, shares.y.face[i]),
            &sum[pointIndex(batch.gave.levelFace[i])].levelCoefficient, stride);
  }
}

void takeForces(const CouplingGrid& grid, const GasAtPoints& gas, Particles& particles,
                ExchangeBatch& batch) {
  BatchShares& shares = batch.shares;
  PointIndices at;
  locate(grid, &particles.position[batch.begin], batch.size, shares,
         [&](auto d, std::size_t i, const auto& x, const auto& y) HWY_ATTR {
           storeIndices(d, {grid.stride, 0}, x, y, i, at);
         });
  for (std::size_t i = 0; i < batch.size; ++i) {
    const Pair d;
    const auto row = [&](const Vec2* cell) HWY_ATTR {
      return between(hn::LoadU(d, &cell[0].x), hn::LoadU(d, &cell[1].x), hn::Set(d, shares.x.volume[i]));
    };
    const Vec2* const cell = &gas.pressureGradient[pointIndex(at.cell[i])];
    const PairOf gradient = between(row(cell), row(cell + grid.stride), hn::Set(d, shares.y.volume[i]));
    const std::size_t p = batch.begin + i;
    const PairOf force = hn::Set(d, particles.drag[p]) * gasVelocity(grid, gas, at, shares, i) -
                         hn::Set(d, shares.coupled[i] * grid.particleVolume) * gradient;
    hn::StoreU(force, d, &particles.external[p].x);
  }
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(findSlip);
HWY_EXPORT(giveDrag);
HWY_EXPORT(takeForces);

void findSlip(const CouplingGrid& grid, const GasAtPoints& gas, const std::vector<double>& voidage,
              const Particles& particles, Numbering sum, ExchangeBatch& batch) {
  HWY_DYNAMIC_DISPATCH(findSlip)(grid, gas, voidage, particles, sum, batch);
}

void giveDrag(const CouplingGrid& grid, double gasStep, const ExchangeBatch& batch, Particles& particles,
              BlockSum<FaceSums>& sum) {
  HWY_DYNAMIC_DISPATCH(giveDrag)(grid, gasStep, batch, particles, sum);
}

void takeForces(const CouplingGrid& grid, const GasAtPoints& gas, Particles& particles,
                ExchangeBatch& batch) {
  HWY_DYNAMIC_DISPATCH(takeForces)(grid, gas, particles, batch);
}

}  // namespace bedmix
#endif
