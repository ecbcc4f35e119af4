// SPDX-License-Identifier: MIT
#include "engine/gas/frame_kernel.h"

#include "engine/gas/independent.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/gas/frame_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE std::ptrdiff_t first(Range places) { return static_cast<std::ptrdiff_t>(places.begin); }
HWY_INLINE std::ptrdiff_t last(Range places) { return static_cast<std::ptrdiff_t>(places.end); }

constexpr std::size_t parts = 8;

HWY_INLINE double sumOf(const double* part) {
  return ((part[0] + part[1]) + (part[2] + part[3])) + ((part[4] + part[5]) + (part[6] + part[7]));
}

/// Sum of term(place) over eight partial sums.
template <class Term>
HWY_INLINE double sum(Range places, const Term& term) {
  double part[parts] = {};
  std::size_t c = places.begin;
  for (; c + parts <= places.end; c += parts)
    for (std::size_t k = 0; k < parts; ++k) part[k] += term(c + k);
  for (std::size_t k = 0; c + k < places.end; ++k) part[k] += term(c + k);
  return sumOf(part);
}

double product(const double* a, const float* b, Range places) {
  return sum(places, [=](std::size_t c) HWY_ATTR { return a[c] * static_cast<double>(b[c]); });
}

double total(const double* a, Range places) {
  return sum(places, [=](std::size_t c) HWY_ATTR { return a[c]; });
}

/// Largest magnitude of term(d, place), a vector.
template <class Term>
HWY_INLINE double largest(Range places, const Term& term) {
  const hn::ScalableTag<double> d;
  const hn::CappedTag<double, 1> one;
  auto sizes = hn::Zero(d);
  std::size_t c = places.begin;
  for (; c + hn::Lanes(d) <= places.end; c += hn::Lanes(d)) sizes = hn::Max(sizes, hn::Abs(term(d, c)));
  double all = hn::GetLane(hn::MaxOfLanes(d, sizes));
  for (; c < places.end; ++c) all = std::max(all, hn::GetLane(hn::Abs(term(one, c))));
  return all;
}

double largestSize(const double* a, Range places) {
  return largest(places, [=](auto d, std::size_t c) HWY_ATTR { return hn::LoadU(d, a + c); });
}

double largestDifference(const double* a, const double* b, Range places) {
  return largest(places,
                 [=](auto d, std::size_t c) HWY_ATTR { return hn::LoadU(d, a + c) - hn::LoadU(d, b + c); });
}

void findImbalance(const FaceFlow& upright, const FaceFlow& level, std::ptrdiff_t stride,
                   const double* growth, const double* open, double* b, Range places) {
  const auto flux = [](const FaceFlow& f, std::ptrdiff_t c)
                        HWY_ATTR { return f.voidage[c] * f.velocity[c] * f.area[c]; };
  const FaceFlow u = upright, v = level;
  BEDMIX_INDEPENDENT
  for (std::ptrdiff_t c = first(places); c < last(places); ++c) {
    const double gain = flux(u, c) - flux(u, c + 1) + flux(v, c) - flux(v, c + stride) - growth[c];
    b[c] = open[c] > 0.0 ? gain : 0.0;
  }
}

double apply(const FrameOperator& a, const double* x, double* image, Range places) {
  const double *west = a.west, *south = a.south;
  const std::ptrdiff_t n = a.stride;
  BEDMIX_INDEPENDENT
  for (std::ptrdiff_t c = first(places); c < last(places); ++c)
    image[c] = (west[c] * (x[c] - x[c - 1]) + west[c + 1] * (x[c] - x[c + 1])) +
               (south[c] * (x[c] - x[c - n]) + south[c + n] * (x[c] - x[c + n]));
  return sum(places, [=](std::size_t c) HWY_ATTR { return x[c] * image[c]; });
}

double advance(double length, const double* direction, const double* image, double* x, double* r,
               float* single, Range places) {
  BEDMIX_INDEPENDENT
  for (std::ptrdiff_t c = first(places); c < last(places); ++c) {
    x[c] += length * direction[c];
    r[c] -= length * image[c];
    single[c] = static_cast<float>(r[c]);
  }
  return HWY_NAMESPACE::largestSize(r, places);
}

void turn(double share, const float* z, double* direction, Range places) {
  BEDMIX_INDEPENDENT
  for (std::ptrdiff_t c = first(places); c < last(places); ++c)
    direction[c] = static_cast<double>(z[c]) + share * direction[c];
}

}  // namespace

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(apply);
HWY_EXPORT(advance);
HWY_EXPORT(turn);
HWY_EXPORT(findImbalance);
HWY_EXPORT(product);
HWY_EXPORT(total);
HWY_EXPORT(largestSize);
HWY_EXPORT(largestDifference);

double apply(const FrameOperator& a, const double* x, double* image, Range places) {
  return HWY_DYNAMIC_DISPATCH(apply)(a, x, image, places);
}
double advance(double length, const double* direction, const double* image, double* x, double* r,
               float* single, Range places) {
  return HWY_DYNAMIC_DISPATCH(advance)(length, direction, image, x, r, single, places);
}
void turn(double share, const float* z, double* direction, Range places) {
  HWY_DYNAMIC_DISPATCH(turn)(share, z, direction, places);
}
void findImbalance(const FaceFlow& upright, const FaceFlow& level, std::ptrdiff_t stride,
                   const double* growth, const double* open, double* b, Range places) {
  HWY_DYNAMIC_DISPATCH(findImbalance)(upright, level, stride, growth, open, b, places);
}
double product(const double* a, const float* b, Range places) {
  return HWY_DYNAMIC_DISPATCH(product)(a, b, places);
}
double total(const double* a, Range places) { return HWY_DYNAMIC_DISPATCH(total)(a, places); }
double largestSize(const double* a, Range places) { return HWY_DYNAMIC_DISPATCH(largestSize)(a, places); }
double largestDifference(const double* a, const double* b, Range places) {
  return HWY_DYNAMIC_DISPATCH(largestDifference)(a, b, places);
}

}  // namespace bedmix
#endif  // HWY_ONCE
