// SPDX-License-Identifier: MIT
#include "engine/coupling/voidage_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/coupling/voidage_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "engine/coupling/locate-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

void depositVolume(const CouplingGrid& grid, std::span<const Vec2> position, BlockSum<double>& sum) {
  const Numbering numbering = sum.numbering();
  BatchShares shares;
  PointIndices at;
  alignas(64) double lowerLeft[batchSize], lowerRight[batchSize], upperLeft[batchSize], upperRight[batchSize];
  for (std::size_t begin = 0; begin < position.size(); begin += batchSize) {
    const std::size_t n = std::min(batchSize, position.size() - begin);
    locate(grid, &position[begin], n, shares,
           [&](auto d, std::size_t i, const auto& x, const auto& y) HWY_ATTR {
             storeIndices(d, numbering, x, y, i, at);
             const auto all = hn::Load(d, shares.coupled + i), above = hn::Load(d, shares.y.volume + i);
             const auto right = all * hn::Load(d, shares.x.volume + i), left = all - right;
             hn::Store(left * above, d, upperLeft + i);
             hn::Store(right * above, d, upperRight + i);
             hn::Store(left - left * above, d, lowerLeft + i);
             hn::Store(right - right * above, d, lowerRight + i);
           });
    for (std::size_t i = 0; i < n; ++i) {
      double* const lower = &sum[pointIndex(at.cell[i])];
      double* const upper = lower + numbering.stride;
      lower[0] += lowerLeft[i];
      lower[1] += lowerRight[i];
      upper[0] += upperLeft[i];
      upper[1] += upperRight[i];
    }
  }
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(depositVolume);

void depositVolume(const CouplingGrid& grid, std::span<const Vec2> position, BlockSum<double>& sum) {
  HWY_DYNAMIC_DISPATCH(depositVolume)(grid, position, sum);
}

}  // namespace bedmix
#endif
