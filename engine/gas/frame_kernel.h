// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/thread_team.h"

#include <cstddef>

namespace bedmix {

/// The pressure system's operator on frames as FaceLayout has them, or on those of a coarser grid: conductance
/// to the place before and to the one below. Its loops run in vectors over ranges of places.
template <class Real>
struct FrameOperator {
  const Real *west = nullptr, *south = nullptr;
  std::ptrdiff_t stride = 0;  // from row to row
};

/// image = A x; returns their product.
double apply(const FrameOperator<double>& a, const double* x, double* image, Range places);
/// One step of conjugate gradients: x += length * direction, r -= length * image, r also in single precision.
/// Returns the largest magnitude in r.
double advance(double length, const double* direction, const double* image, double* x, double* r,
               float* single, Range places);
/// direction = z + share * direction
void turn(double share, const float* z, double* direction, Range places);

/// Damped Jacobi: to = from + damping / D * (b - A from).
void relax(const FrameOperator<float>& a, const float* perDiagonal, const float* b, float damping,
           const float* from, float* to, Range places);
/// Two of them that begin with zero.
void relaxTwice(const FrameOperator<float>& a, const float* perDiagonal, const float* b, float first,
                float second, float* to, Range places);
/// r = b - A x
void findResidual(const FrameOperator<float>& a, const float* b, const float* x, float* r, Range places);

// Sums are taken in an order of their own, eight partial ones whatever a vector holds.

double product(const double* a, const float* b, Range places);
double total(const double* a, Range places);
/// Largest magnitude.
double largestSize(const double* a, Range places);

}  // namespace bedmix
