// SPDX-License-Identifier: MIT
#include "tests/bench/machine_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/machine_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bedmix::bench::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Enough independent chains to hide how long an operation takes, few enough for sixteen registers.
template <bool fuse>
Arithmetic chains(std::size_t rounds) {
  const hn::ScalableTag<double> d;
  const auto factor = hn::Set(d, 0.999999), summand = hn::Set(d, 1e-6);
  const auto next = [&](auto x) HWY_ATTR {
    return fuse ? hn::MulAdd(x, factor, summand) : hn::Add(hn::Mul(x, factor), summand);
  };
  auto a = hn::Iota(d, 0.0), b = hn::Iota(d, 1.0), c = hn::Iota(d, 2.0), e = hn::Iota(d, 3.0);
  auto f = hn::Iota(d, 4.0), g = hn::Iota(d, 5.0), h = hn::Iota(d, 6.0), i = hn::Iota(d, 7.0);
  auto j = hn::Iota(d, 8.0), k = hn::Iota(d, 9.0), l = hn::Iota(d, 10.0), m = hn::Iota(d, 11.0);
  for (std::size_t r = 0; r < rounds; ++r) {
    a = next(a), b = next(b), c = next(c), e = next(e), f = next(f), g = next(g);
    h = next(h), i = next(i), j = next(j), k = next(k), l = next(l), m = next(m);
  }
  const auto sum = [](auto x, auto y) HWY_ATTR { return hn::Add(x, y); };
  const auto all = sum(sum(sum(a, b), sum(c, e)), sum(sum(sum(f, g), sum(h, i)), sum(sum(j, k), sum(l, m))));
  return {24.0 * static_cast<double>(hn::Lanes(d) * rounds), hn::GetLane(hn::SumOfLanes(d, all))};
}

}  // namespace

void triad(double* a, const double* b, const double* c, double s, std::size_t n) {
  const hn::ScalableTag<double> d;
  const auto factor = hn::Set(d, s);
  for (std::size_t i = 0; i + hn::Lanes(d) <= n; i += hn::Lanes(d))
    hn::StoreU(hn::Add(hn::LoadU(d, b + i), hn::Mul(factor, hn::LoadU(d, c + i))), d, a + i);
}

Arithmetic productsAndSums(std::size_t rounds) { return chains<false>(rounds); }
Arithmetic fused(std::size_t rounds) { return chains<true>(rounds); }

}  // namespace bedmix::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix::bench {

HWY_EXPORT(triad);
HWY_EXPORT(productsAndSums);
HWY_EXPORT(fused);

void triad(double* a, const double* b, const double* c, double s, std::size_t n) {
  HWY_DYNAMIC_DISPATCH(triad)(a, b, c, s, n);
}
Arithmetic productsAndSums(std::size_t rounds) { return HWY_DYNAMIC_DISPATCH(productsAndSums)(rounds); }
Arithmetic fused(std::size_t rounds) { return HWY_DYNAMIC_DISPATCH(fused)(rounds); }

}  // namespace bedmix::bench
#endif
