// SPDX-License-Identifier: MIT

// Powers in vectors: once a target, in the manner of Highway.
#if defined(BEDMIX_CORE_POWER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef BEDMIX_CORE_POWER_INL_H_
#undef BEDMIX_CORE_POWER_INL_H_
#else
#define BEDMIX_CORE_POWER_INL_H_
#endif

#include <cstddef>
#include <cstdint>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The sum of c[k] x^k, even and odd powers apart, which shortens the chain of roundings to wait for.
template <class D, class V, std::size_t n>
HWY_INLINE V polynomial(D d, V x, const double (&c)[n]) {
  static_assert(n % 2 == 0);
  const V square = x * x;
  V even = hn::Set(d, c[n - 2]), odd = hn::Set(d, c[n - 1]);
  for (std::size_t k = n - 2; k > 0; k -= 2) {
    even = even * square + hn::Set(d, c[k - 2]);
    odd = odd * square + hn::Set(d, c[k - 1]);
  }
  return even + odd * x;
}

/// log2 of normal numbers: x = 2^e m with m from sqrt(1/2) to sqrt(2), ln m = 2 artanh((m - 1) / (m + 1)).
template <class D, class V>
HWY_INLINE V log2Of(D d, V x) {
  const hn::RebindToUnsigned<D> bits;
  constexpr std::uint64_t one = 0x3FF0000000000000, rootHalf = 0x3FE6A09E667F3BCD,
                          mantissa = 0x000FFFFFFFFFFFFF;
  constexpr double whole = 0x1p52;  // the integers that follow have their value in the last bits
  const auto shifted = hn::BitCast(bits, x) + hn::Set(bits, one - rootHalf);
  const auto exponent = hn::Or(hn::ShiftRight<52>(shifted), hn::BitCast(bits, hn::Set(d, whole)));
  const V e = hn::BitCast(d, exponent) - hn::Set(d, whole + 1023.0);
  const V m = hn::BitCast(d, hn::And(shifted, hn::Set(bits, mantissa)) + hn::Set(bits, rootHalf));
  const V s = (m - hn::Set(d, 1.0)) / (m + hn::Set(d, 1.0));
  constexpr double c[]{1.0,        1.0 / 3.0,  1.0 / 5.0,  1.0 / 7.0,  1.0 / 9.0,
                       1.0 / 11.0, 1.0 / 13.0, 1.0 / 15.0, 1.0 / 17.0, 1.0 / 19.0};
  constexpr double twoOverLn2 = 2.88539008177792681472;
  return e + hn::Set(d, twoOverLn2) * s * polynomial(d, s * s, c);
}

/// 2^t for |t| < 1000.
template <class D, class V>
HWY_INLINE V exp2Of(D d, V t) {
  const hn::RebindToUnsigned<D> bits;
  constexpr double whole = 0x1.8p52;
  const V n = hn::Round(t);
  constexpr double ln2 = 0.693147180559945309417;
  constexpr double c[]{1.0,
                       1.0,
                       1.0 / 2.0,
                       1.0 / 6.0,
                       1.0 / 24.0,
                       1.0 / 120.0,
                       1.0 / 720.0,
                       1.0 / 5040.0,
                       1.0 / 40320.0,
                       1.0 / 362880.0,
                       1.0 / 3628800.0,
                       1.0 / 39916800.0,
                       1.0 / 479001600.0,
                       1.0 / 6227020800.0};
  const V fraction = polynomial(d, (t - n) * hn::Set(d, ln2), c);
  const auto exponent = hn::BitCast(bits, n + hn::Set(d, whole)) + hn::Set(bits, std::uint64_t{1023});
  return fraction * hn::BitCast(d, hn::ShiftLeft<52>(exponent));
}

/// x^exponent for 0 <= x < 1e300 and |exponent| < 3, to 1e-14; 0 for any x below 1e-300. Library functions
/// for this differ from machine to machine in the last bits; these are sums and products everywhere.
template <class D, class V>
HWY_INLINE V power(D d, V x, double exponent) {
  const V value = exp2Of(d, log2Of(d, x) * hn::Set(d, exponent));
  return hn::IfThenElseZero(x >= hn::Set(d, 1e-300), value);
}

/// The same for exponents from -3 to 3 of each its own, as long as what comes out is below 1e300; what would
/// be below 1e-300 comes out as about that.
template <class D, class V>
HWY_INLINE V power(D d, V x, V exponent) {
  const V value = exp2Of(d, hn::Max(log2Of(d, x) * exponent, hn::Set(d, -999.0)));
  return hn::IfThenElseZero(x >= hn::Set(d, 1e-300), value);
}

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
