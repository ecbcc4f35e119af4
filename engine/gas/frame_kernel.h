// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/thread_team.h"

#include <cstddef>

namespace bedmix {

// Loops over frames as FaceLayout has them, in vectors.

/// The pressure system's matrix: conductance to the place before and to the one below.
struct FrameOperator {
  const double *west = nullptr, *south = nullptr;
  std::ptrdiff_t stride = 0;  // from row to row
};

/// image = A x; returns their product.
double apply(const FrameOperator& a, const double* x, double* image, Range places);
/// One step of conjugate gradients: x += length * direction, r -= length * image, r also in single precision.
/// Returns the largest magnitude in r.
double advance(double length, const double* direction, const double* image, double* x, double* r,
               float* single, Range places);
/// direction = z + share * direction
void turn(double share, const float* z, double* direction, Range places);

/// Cells of a staggered grid: what flows in through upright and level faces, each frame with its velocity,
/// voidage and area, less what the voids grow by; 0 where `open` is.
struct FaceFlow {
  const double *velocity = nullptr, *voidage = nullptr, *area = nullptr;
};
void findImbalance(const FaceFlow& upright, const FaceFlow& level, std::ptrdiff_t stride,
                   const double* growth, const double* open, double* b, Range places);

// Sums are taken in an order of their own, eight partial ones whatever a vector holds; maxima have none.

double product(const double* a, const float* b, Range places);
double total(const double* a, Range places);
/// Largest magnitude of a, and of a - b.
double largestSize(const double* a, Range places);
double largestDifference(const double* a, const double* b, Range places);

}  // namespace bedmix
