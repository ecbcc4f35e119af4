// SPDX-License-Identifier: MIT
#include "engine/coupling/voidage_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/coupling/voidage_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "engine/coupling/locate-inl.h"

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

template <bool mixed>
void depositAll(const CouplingGrid& grid, std::span<const Vec2> position, const double* radii,
                BlockSum<double>& sum) {
  const Sizes<mixed> sizes{grid, radii};
  const Numbering numbering = sum.numbering();
  alignas(64) double cell[batchSize];
  alignas(64) double lowerLeft[batchSize], lowerRight[batchSize], upperLeft[batchSize], upperRight[batchSize];
  for (std::size_t begin = 0; begin < position.size(); begin += batchSize) {
    const std::size_t n = std::min(batchSize, position.size() - begin);
    locate(grid, &position[begin], n, [&](auto d, std::size_t i, auto x, auto y, auto coupled) HWY_ATTR {
      const auto perDiameter = sizes.perDiameter(d, begin + i),
                 whole = sizes.inVolumes(d, begin + i, coupled);
      const auto right = whole * volumeShare(d, perDiameter, x), left = whole - right;
      const auto above = volumeShare(d, perDiameter, y);
      hn::Store(left * above, d, upperLeft + i);
      hn::Store(right * above, d, upperRight + i);
      hn::Store(left - left * above, d, lowerLeft + i);
      hn::Store(right - right * above, d, lowerRight + i);
      hn::Store(cellIndex(d, numbering, x, y), d, cell + i);
    });
    forDistant(n, [&](std::size_t i) HWY_ATTR {
      const hn::CappedTag<double, 1> d;
      const auto add = [d](double* to, const double* share)
                           HWY_ATTR { hn::Store(hn::Load(d, to) + hn::Load(d, share), d, to); };
      double* const lower = &sum[pointIndex(cell[i])];
      double* const upper = lower + numbering.stride;
      add(lower, lowerLeft + i);
      add(lower + 1, lowerRight + i);
      add(upper, upperLeft + i);
      add(upper + 1, upperRight + i);
    });
  }
}

}  // namespace

void depositVolume(const CouplingGrid& grid, std::span<const Vec2> position, const double* radii,
                   BlockSum<double>& sum) {
  (radii ? depositAll<true> : depositAll<false>)(grid, position, radii, sum);
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(depositVolume);

void depositVolume(const CouplingGrid& grid, std::span<const Vec2> position, const double* radii,
                   BlockSum<double>& sum) {
  HWY_DYNAMIC_DISPATCH(depositVolume)(grid, position, radii, sum);
}

}  // namespace bedmix
#endif
