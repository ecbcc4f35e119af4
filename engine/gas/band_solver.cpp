// SPDX-License-Identifier: MIT
#include "engine/gas/band_solver.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

// Rows of the band are handled in pieces of this many entries; zeros behind them make that harmless.
constexpr std::size_t piece = 4;

std::size_t roundUp(std::size_t n) { return (n + piece - 1) / piece * piece; }

/// y -= factor x
void subtract(double factor, const double* __restrict x, double* __restrict y, std::size_t n) {
  for (std::size_t i = 0; i < n; i += piece)
    for (std::size_t k = i; k < i + piece; ++k) y[k] -= factor * x[k];
}

double product(const double* x, const double* y, std::size_t n) {
  double sum[piece] = {};
  for (std::size_t i = 0; i < n; i += piece)
    for (std::size_t k = 0; k < piece; ++k) sum[k] += x[i + k] * y[i + k];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

}  // namespace

BandSolver::BandSolver(const FaceLayout& layout) : layout_(layout) {
  const auto columns = static_cast<std::size_t>(layout.columns), rows = static_cast<std::size_t>(layout.rows);
  cells_ = columns * rows;
  width_ = std::min(columns, rows);
  columnStep_ = columns <= rows ? 1 : rows;
  rowStep_ = columns <= rows ? columns : 1;
  rowLength_ = roundUp(width_ + 1) + piece;
  band_.resize((cells_ + width_) * rowLength_);
  perPivot_.resize(cells_);
  x_.resize(cells_ + roundUp(width_));
}

bool BandSolver::prepare(const std::vector<double>& coefficient) {
  const FaceLayout& l = layout_;
  const double *west = coefficient.data(), *south = west + l.size;
  std::fill(band_.begin(), band_.end(), 0.0);
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i) {
      const int c = l.at(i, j);
      double* row = &band_[unknown(i, j) * rowLength_];
      const double sum = west[c] + west[c + 1] + south[c] + south[c + l.stride];
      row[0] = sum != 0.0 ? sum : 1.0;
      // The neighbours to the right and above; a band of one cell has both in the same place.
      if (i + 1 < l.columns) row[columnStep_] -= west[c + 1];
      if (j + 1 < l.rows) row[rowStep_] -= south[c + l.stride];
    }

  bool sound = true;
  for (std::size_t k = 0; k < cells_; ++k) {
    const double* row = &band_[k * rowLength_];
    sound = sound && row[0] > 0.0 && std::isfinite(row[0]);
    perPivot_[k] = 1.0 / row[0];
    for (std::size_t m = 1; m <= width_; ++m)
      subtract(row[m] * perPivot_[k], row + m, &band_[(k + m) * rowLength_], width_ + 1 - m);
  }
  return sound;
}

void BandSolver::solve(const std::vector<double>& b, std::vector<double>& p) {
  const FaceLayout& l = layout_;
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i) x_[unknown(i, j)] = b[l.at(i, j)];
  for (std::size_t k = 0; k < cells_; ++k)
    subtract(x_[k] * perPivot_[k], &band_[k * rowLength_ + 1], &x_[k + 1], width_);
  for (std::size_t k = cells_; k-- > 0;)
    x_[k] = perPivot_[k] * (x_[k] - product(&band_[k * rowLength_ + 1], &x_[k + 1], width_));
  for (int j = 0; j < l.rows; ++j)
    for (int i = 0; i < l.columns; ++i) p[l.at(i, j)] = x_[unknown(i, j)];
}

}  // namespace bedmix
