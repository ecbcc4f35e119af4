// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace bedmix {

// Sums over vectors in an order of their own: eight partial ones, so that lanes of any number can share them.

namespace detail {

template <class Term>
double sumOf(int n, Term&& term) {
  double part[8] = {};
  int i = 0;
  for (; i + 8 <= n; i += 8)
    for (int k = 0; k < 8; ++k) part[k] += term(i + k);
  for (int k = 0; i + k < n; ++k) part[k] += term(i + k);
  return ((part[0] + part[1]) + (part[2] + part[3])) + ((part[4] + part[5]) + (part[6] + part[7]));
}

}  // namespace detail

template <class A, class B>
double product(const A* a, const B* b, int n) {
  return detail::sumOf(n, [=](int i) { return static_cast<double>(a[i]) * static_cast<double>(b[i]); });
}
inline double total(const double* a, int n) {
  return detail::sumOf(n, [=](int i) { return a[i]; });
}
/// Largest magnitude.
inline double largestSize(const double* a, int n) {
  double largest[8] = {};
  int i = 0;
  for (; i + 8 <= n; i += 8)
    for (int k = 0; k < 8; ++k) {
      const double size = std::abs(a[i + k]);
      largest[k] = size > largest[k] ? size : largest[k];
    }
  for (; i < n; ++i) largest[0] = std::abs(a[i]) > largest[0] ? std::abs(a[i]) : largest[0];
  double all = 0.0;
  for (double l : largest) all = l > all ? l : all;
  return all;
}

}  // namespace bedmix
