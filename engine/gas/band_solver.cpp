// SPDX-License-Identifier: MIT
#include "engine/gas/band_solver.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/gas/band_solver.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bedmix::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Unknowns go four by four, so a vector has at most so many lanes. Then rows of the band and the unknowns
// they meet begin at multiples of four, and what one block has stored the next one loads as it was stored.
using Lanes = hn::CappedTag<double, 4>;

/// to[begin, end) -= sum over four rows of factor * row, one after the other.
HWY_INLINE void subtractRows(const double* factors, std::size_t factorStep, const double* rows,
                             std::size_t length, double* to, std::size_t begin, std::size_t end) {
  const Lanes d;
  const auto f0 = hn::Set(d, factors[0]), f1 = hn::Set(d, factors[factorStep]);
  const auto f2 = hn::Set(d, factors[2 * factorStep]), f3 = hn::Set(d, factors[3 * factorStep]);
  for (std::size_t t = begin; t < end; t += hn::Lanes(d)) {
    auto y = hn::LoadU(d, to + t);
    y = y - f0 * hn::LoadU(d, rows + t);
    y = y - f1 * hn::LoadU(d, rows + length + t);
    y = y - f2 * hn::LoadU(d, rows + 2 * length + t);
    y = y - f3 * hn::LoadU(d, rows + 3 * length + t);
    hn::StoreU(y, d, to + t);
  }
}

/// Sum over four partial sums of a[i] * b[i].
HWY_INLINE double product(const double* a, const double* b, std::size_t n) {
  const Lanes d;
  alignas(64) double sum[4];
  for (std::size_t l = 0; l < 4; l += hn::Lanes(d)) {
    auto part = hn::Zero(d);
    for (std::size_t i = l; i < n; i += 4) part = part + hn::LoadU(d, a + i) * hn::LoadU(d, b + i);
    hn::Store(part, d, sum + l);
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/// Turns the band of A into that of L^T. `scaled` is room for four rows.
bool factorize(double* band, double* perPivot, double* scaled, std::size_t blocks, std::size_t width,
               std::size_t length) {
  const Lanes d;
  bool sound = true;
  for (std::size_t block = 0; block < blocks; ++block, perPivot += 4) {
    double* const rows = band + 4 * block * length;
    for (std::size_t q = 0; q < 4; ++q) {
      double* const row = rows + q * length;
      sound = sound && row[q] > 0.0 && row[q] <= hwy::HighestValue<double>();
      perPivot[q] = 1.0 / row[q];
      const auto p = hn::Set(d, perPivot[q]);
      for (std::size_t t = 0; t < length; t += hn::Lanes(d))
        hn::StoreU(hn::LoadU(d, row + t) * p, d, scaled + q * length + t);
      for (std::size_t m = q + 1; m < 4; ++m) {
        const auto f = hn::Set(d, scaled[q * length + m]);
        for (std::size_t t = 0; t < length; t += hn::Lanes(d))
          hn::StoreU(hn::LoadU(d, rows + m * length + t) - f * hn::LoadU(d, row + t), d,
                     rows + m * length + t);
      }
    }
    // The rows behind this block that it is coupled with.
    for (std::size_t c = 4; c < 4 + width; ++c) {
      const std::size_t begin = c / 4 * 4;
      subtractRows(scaled + c, length, rows, length, rows + c * length - begin, begin, length);
    }
    std::copy(scaled, scaled + 4 * length, rows);
  }
  return sound;
}

void substitute(const double* band, const double* perPivot, double* x, std::size_t blocks,
                std::size_t length) {
  for (std::size_t block = 0; block < blocks; ++block) {
    const double *r0 = band + 4 * block * length, *r1 = r0 + length, *r2 = r1 + length;
    double* y = x + 4 * block;
    y[1] -= r0[1] * y[0];
    y[2] = (y[2] - r0[2] * y[0]) - r1[2] * y[1];
    y[3] = ((y[3] - r0[3] * y[0]) - r1[3] * y[1]) - r2[3] * y[2];
    subtractRows(y, 1, r0, length, y, 4, length);
  }
  for (std::size_t block = blocks; block-- > 0;) {
    const double *r0 = band + 4 * block * length, *r1 = r0 + length, *r2 = r1 + length, *r3 = r2 + length;
    const double* p = perPivot + 4 * block;
    double* y = x + 4 * block;
    const std::size_t n = length - 4;
    y[3] = y[3] * p[3] - product(r3 + 4, y + 4, n);
    y[2] = (y[2] * p[2] - product(r2 + 4, y + 4, n)) - r2[3] * y[3];
    y[1] = ((y[1] * p[1] - product(r1 + 4, y + 4, n)) - r1[2] * y[2]) - r1[3] * y[3];
    y[0] = (((y[0] * p[0] - product(r0 + 4, y + 4, n)) - r0[1] * y[1]) - r0[2] * y[2]) - r0[3] * y[3];
  }
}

}  // namespace

}  // namespace bedmix::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bedmix {

HWY_EXPORT(factorize);
HWY_EXPORT(substitute);

BandSolver::BandSolver(const FaceLayout& layout) : layout_(layout) {
  const auto columns = static_cast<std::size_t>(layout.columns), rows = static_cast<std::size_t>(layout.rows);
  const std::size_t columnWidth = layout.repeats ? 2 * rows : rows;  // of a band of columns
  width_ = std::min(columns, columnWidth);
  columnStep_ = columns <= columnWidth ? 1 : rows;
  rowStep_ = columns <= columnWidth ? columns : 1;
  for (std::size_t i = 0; layout.repeats && i < columns; ++i) {
    const std::size_t fromEnd = columns - 1 - i;
    columnPlace_.push_back(i <= fromEnd ? 2 * i : 2 * fromEnd + 1);
  }
  blocks_ = (columns * rows + 3) / 4;
  rowLength_ = (width_ + 3) / 4 * 4 + 4;
  band_.resize((4 * blocks_ + width_) * rowLength_);
  perPivot_.resize(4 * blocks_);
  x_.resize(4 * blocks_ + rowLength_);
  scaled_.resize(4 * rowLength_);
}

bool BandSolver::prepare(const std::vector<double>& conductance) {
  std::fill(band_.begin(), band_.end(), 0.0);
  for (std::size_t k = 0; k < 4 * blocks_; ++k) band_[k * rowLength_ + k % 4] = 1.0;
  layout_.repeats ? fill<true>(conductance) : fill<false>(conductance);
  return HWY_DYNAMIC_DISPATCH(factorize)(band_.data(), perPivot_.data(), scaled_.data(), blocks_, width_,
                                         rowLength_);
}

template <bool around>
void BandSolver::fill(const std::vector<double>& conductance) {
  const FaceLayout& l = layout_;
  const double *west = conductance.data(), *south = west + l.size;
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i) {
      const int c = l.at(i, j);
      const std::size_t k = unknown<around>(i, j);
      double* diagonal = &band_[k * rowLength_ + k % 4];
      const double sum = west[c] + west[c + 1] + south[c] + south[c + l.stride];
      if (sum != 0.0) *diagonal = sum;
      // The neighbours to the right and above.
      if constexpr (around) {
        const std::size_t right = unknown<around>((i + 1) % l.columns, j), first = std::min(k, right);
        band_[first * rowLength_ + first % 4 + std::max(k, right) - first] = -west[c + 1];
      } else if (i + 1 < l.columns) {
        diagonal[columnStep_] = -west[c + 1];
      }
      if (j + 1 < l.rows) diagonal[rowStep_] = -south[c + l.stride];
    }
}

void BandSolver::solve(const std::vector<double>& b, std::vector<double>& p) {
  layout_.repeats ? solveFor<true>(b, p) : solveFor<false>(b, p);
}

template <bool around>
void BandSolver::solveFor(const std::vector<double>& b, std::vector<double>& p) {
  const FaceLayout& l = layout_;
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i) x_[unknown<around>(i, j)] = b[l.at(i, j)];
  HWY_DYNAMIC_DISPATCH(substitute)(band_.data(), perPivot_.data(), x_.data(), blocks_, rowLength_);
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i) p[l.at(i, j)] = x_[unknown<around>(i, j)];
}

}  // namespace bedmix
#endif  // HWY_ONCE
