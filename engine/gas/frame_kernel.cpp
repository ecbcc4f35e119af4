// SPDX-License-Identifier: MIT
#include "engine/gas/frame_kernel.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/gas/frame_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

// No place that these loops write is read as another's neighbour, which the compiler cannot know.
#define BEDMIX_PLACES(c)                                                        \
  _Pragma("GCC ivdep") for (auto c = static_cast<std::ptrdiff_t>(places.begin); \
                            c < static_cast<std::ptrdiff_t>(places.end); ++c)

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;

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

double largestSize(const double* a, Range places) {
  const hn::ScalableTag<double> d;
  auto largest = hn::Zero(d);
  std::size_t c = places.begin;
  for (; c + hn::Lanes(d) <= places.end; c += hn::Lanes(d))
    largest = hn::Max(largest, hn::Abs(hn::LoadU(d, a + c)));
  double all = hn::GetLane(hn::MaxOfLanes(d, largest));
  for (; c < places.end; ++c) all = std::abs(a[c]) > all ? std::abs(a[c]) : all;
  return all;
}

/// (A x)[c]: what flows out to the four neighbours.
template <class Real>
HWY_INLINE Real outflow(const Real* west, const Real* south, std::ptrdiff_t stride, const Real* x,
                        std::ptrdiff_t c) {
  return (west[c] * (x[c] - x[c - 1]) + west[c + 1] * (x[c] - x[c + 1])) +
         (south[c] * (x[c] - x[c - stride]) + south[c + stride] * (x[c] - x[c + stride]));
}

double apply(const FrameOperator<double>& a, const double* x, double* image, Range places) {
  const double *west = a.west, *south = a.south;
  const std::ptrdiff_t stride = a.stride;
  BEDMIX_PLACES(c) image[c] = outflow(west, south, stride, x, c);
  return sum(places, [=](std::size_t c) HWY_ATTR { return x[c] * image[c]; });
}

double advance(double length, const double* direction, const double* image, double* x, double* r,
               float* single, Range places) {
  BEDMIX_PLACES(c) {
    x[c] += length * direction[c];
    r[c] -= length * image[c];
    single[c] = static_cast<float>(r[c]);
  }
  return HWY_NAMESPACE::largestSize(r, places);
}

void turn(double share, const float* z, double* direction, Range places) {
  BEDMIX_PLACES(c) direction[c] = static_cast<double>(z[c]) + share * direction[c];
}

void relax(const FrameOperator<float>& a, const float* perDiagonal, const float* b, float damping,
           const float* from, float* to, Range places) {
  const float *west = a.west, *south = a.south;
  const std::ptrdiff_t stride = a.stride;
  BEDMIX_PLACES(c)
  to[c] = from[c] + damping * perDiagonal[c] * (b[c] - outflow(west, south, stride, from, c));
}

void relaxTwice(const FrameOperator<float>& a, const float* perDiagonal, const float* b, float first,
                float second, float* to, Range places) {
  const float *west = a.west, *south = a.south;
  const std::ptrdiff_t n = a.stride;
  BEDMIX_PLACES(c) {
    const float own = perDiagonal[c] * b[c];
    const float flow =
        (west[c] * (own - perDiagonal[c - 1] * b[c - 1]) + west[c + 1] * (own - perDiagonal[c + 1] * b[c + 1])) +
        (south[c] * (own - perDiagonal[c - n] * b[c - n]) + south[c + n] * (own - perDiagonal[c + n] * b[c + n]));
    to[c] = first * own + second * perDiagonal[c] * (b[c] - first * flow);
  }
}

void findResidual(const FrameOperator<float>& a, const float* b, const float* x, float* r, Range places) {
  const float *west = a.west, *south = a.south;
  const std::ptrdiff_t stride = a.stride;
  BEDMIX_PLACES(c) r[c] = b[c] - outflow(west, south, stride, x, c);
}

}  // namespace

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(apply);
HWY_EXPORT(advance);
HWY_EXPORT(turn);
HWY_EXPORT(relax);
HWY_EXPORT(relaxTwice);
HWY_EXPORT(findResidual);
HWY_EXPORT(product);
HWY_EXPORT(total);
HWY_EXPORT(largestSize);

double apply(const FrameOperator<double>& a, const double* x, double* image, Range places) {
  return HWY_DYNAMIC_DISPATCH(apply)(a, x, image, places);
}
double advance(double length, const double* direction, const double* image, double* x, double* r,
               float* single, Range places) {
  return HWY_DYNAMIC_DISPATCH(advance)(length, direction, image, x, r, single, places);
}
void turn(double share, const float* z, double* direction, Range places) {
  HWY_DYNAMIC_DISPATCH(turn)(share, z, direction, places);
}
void relax(const FrameOperator<float>& a, const float* perDiagonal, const float* b, float damping,
           const float* from, float* to, Range places) {
  HWY_DYNAMIC_DISPATCH(relax)(a, perDiagonal, b, damping, from, to, places);
}
void relaxTwice(const FrameOperator<float>& a, const float* perDiagonal, const float* b, float first,
                float second, float* to, Range places) {
  HWY_DYNAMIC_DISPATCH(relaxTwice)(a, perDiagonal, b, first, second, to, places);
}
void findResidual(const FrameOperator<float>& a, const float* b, const float* x, float* r, Range places) {
  HWY_DYNAMIC_DISPATCH(findResidual)(a, b, x, r, places);
}
double product(const double* a, const float* b, Range places) {
  return HWY_DYNAMIC_DISPATCH(product)(a, b, places);
}
double total(const double* a, Range places) { return HWY_DYNAMIC_DISPATCH(total)(a, places); }
double largestSize(const double* a, Range places) { return HWY_DYNAMIC_DISPATCH(largestSize)(a, places); }

}  // namespace bedmix
#endif  // HWY_ONCE
