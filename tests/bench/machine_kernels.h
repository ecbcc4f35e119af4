// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace bedmix::bench {

/// a = b + s c, of n doubles; STREAM's triad.
void triad(double* a, const double* b, const double* c, double s, std::size_t n);

/// Floating-point operations in registers, `rounds` times; half of them products, half sums. They return what
/// they computed, so that it cannot be left out.
struct Arithmetic {
  double operations;
  double result;
};
/// One after the other, as all of bedmix does it.
Arithmetic productsAndSums(std::size_t rounds);
/// Fused, where the level has such an instruction.
Arithmetic fused(std::size_t rounds);

}  // namespace bedmix::bench
