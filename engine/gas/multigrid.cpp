// SPDX-License-Identifier: MIT
#include "engine/gas/multigrid.h"

#include <algorithm>
#include <numeric>

namespace bedmix {

namespace {

constexpr int sweeps = 2;             // before and after the coarse correction
constexpr int coarsestSweeps = 16;    // forward and backward; the coarsest level has a handful of cells
constexpr double weakCoupling = 0.2;  // of the other direction's: joining along it would not help

}  // namespace

Multigrid::Level::Level(int c, int r)
    : columns(c), rows(r), stride(c + 2), joinColumns(c > 1), joinRows(r > 1) {
  const auto size = static_cast<std::size_t>(stride) * static_cast<std::size_t>(r + 2);
  for (std::vector<double>* field : {&west, &south, &outlet, &perDiagonal, &x, &b, &residual})
    field->assign(size, 0.0);
}

void Multigrid::Level::updateDiagonal() {
  for (int r = 0; r < rows; ++r)
    for (int c = at(0, r); c < at(columns, r); ++c) {
      const double diagonal = west[c] + west[c + 1] + south[c] + south[c + stride] + outlet[c];
      perDiagonal[c] = diagonal > 0.0 ? 1.0 / diagonal : 0.0;
    }
}

void Multigrid::Level::sweep(bool forward) {
  const auto relax = [this](int c) {
    x[c] = perDiagonal[c] * (b[c] + west[c] * x[c - 1] + west[c + 1] * x[c + 1] + south[c] * x[c - stride] +
                             south[c + stride] * x[c + stride]);
  };
  if (forward)
    for (int r = 0; r < rows; ++r)
      for (int c = at(0, r); c < at(columns, r); ++c) relax(c);
  else
    for (int r = rows - 1; r >= 0; --r)
      for (int c = at(columns, r) - 1; c >= at(0, r); --c) relax(c);
}

void Multigrid::Level::updateResidual() {
  for (int r = 0; r < rows; ++r)
    for (int c = at(0, r); c < at(columns, r); ++c) {
      const double diagonal = west[c] + west[c + 1] + south[c] + south[c + stride] + outlet[c];
      residual[c] = b[c] - diagonal * x[c] + west[c] * x[c - 1] + west[c + 1] * x[c + 1] +
                    south[c] * x[c - stride] + south[c + stride] * x[c + stride];
    }
}

Multigrid::Multigrid(const FaceLayout& layout, const std::vector<int>& unknownOfCell) {
  levels_.emplace_back(layout.columns, layout.rows);
  cellOfUnknown_.resize(layout.openCells.size());
  for (int cell : layout.openCells)
    cellOfUnknown_[unknownOfCell[cell]] = levels_[0].at(cell % layout.columns, cell / layout.columns);
}

void Multigrid::prepare(const FaceLayout& layout, const std::vector<double>& coefficient) {
  Level& finest = levels_.front();
  for (std::size_t k = 0; k < layout.volumes.size(); ++k) {
    const MomentumVolume& v = layout.volumes[k];
    if (v.cellPlus < 0) {
      finest.outlet[finest.at(v.cellMinus % layout.columns, v.cellMinus / layout.columns)] = coefficient[k];
      continue;
    }
    const int plus = finest.at(v.cellPlus % layout.columns, v.cellPlus / layout.columns);
    (v.vertical ? finest.south : finest.west)[plus] = coefficient[k];
  }
  finest.updateDiagonal();

  for (std::size_t l = 0; levels_[l].columns * levels_[l].rows > 4; ++l) {
    Level& fine = levels_[l];
    const double across = std::accumulate(fine.west.begin(), fine.west.end(), 0.0);
    const double up = std::accumulate(fine.south.begin(), fine.south.end(), 0.0);
    fine.joinColumns = fine.columns > 1 && (fine.rows == 1 || across > weakCoupling * up);
    fine.joinRows = fine.rows > 1 && (fine.columns == 1 || up > weakCoupling * across);
    const int columns = fine.joinColumns ? (fine.columns + 1) / 2 : fine.columns;
    const int rows = fine.joinRows ? (fine.rows + 1) / 2 : fine.rows;
    // Shapes settle at the first call and change only where a direction's coupling crosses the bound.
    if (l + 1 == levels_.size() || levels_[l + 1].columns != columns || levels_[l + 1].rows != rows) {
      levels_.erase(levels_.begin() + static_cast<std::ptrdiff_t>(l) + 1, levels_.end());
      levels_.emplace_back(columns, rows);
    }
    coarsen(levels_[l], levels_[l + 1]);
    levels_[l + 1].updateDiagonal();
  }
}

void Multigrid::coarsen(const Level& fine, Level& coarse) const {
  for (std::vector<double>* field : {&coarse.west, &coarse.south, &coarse.outlet})
    std::fill(field->begin(), field->end(), 0.0);
  const double across = fine.joinColumns ? 0.5 : 1.0, up = fine.joinRows ? 0.5 : 1.0;
  for (int r = 0; r < fine.rows; ++r)
    for (int c = 0; c < fine.columns; ++c) {
      const int from = fine.at(c, r);
      const int to = coarse.at(fine.joinColumns ? c / 2 : c, fine.joinRows ? r / 2 : r);
      if (!fine.joinColumns || c % 2 == 0) coarse.west[to] += across * fine.west[from];
      if (!fine.joinRows || r % 2 == 0) coarse.south[to] += up * fine.south[from];
      coarse.outlet[to] += up * fine.outlet[from];
    }
}

void Multigrid::cycle(std::size_t l) const {
  Level& fine = levels_[l];
  std::fill(fine.x.begin(), fine.x.end(), 0.0);
  if (l + 1 == levels_.size()) {
    for (int i = 0; i < coarsestSweeps; ++i) fine.sweep(true);
    for (int i = 0; i < coarsestSweeps; ++i) fine.sweep(false);
    return;
  }
  for (int i = 0; i < sweeps; ++i) fine.sweep(true);
  fine.updateResidual();

  Level& coarse = levels_[l + 1];
  std::fill(coarse.b.begin(), coarse.b.end(), 0.0);
  const auto parent = [&](int c, int r) {
    return coarse.at(fine.joinColumns ? c / 2 : c, fine.joinRows ? r / 2 : r);
  };
  for (int r = 0; r < fine.rows; ++r)
    for (int c = 0; c < fine.columns; ++c) coarse.b[parent(c, r)] += fine.residual[fine.at(c, r)];
  cycle(l + 1);
  for (int r = 0; r < fine.rows; ++r)
    for (int c = 0; c < fine.columns; ++c) {
      const int cell = fine.at(c, r);
      if (fine.perDiagonal[cell] > 0.0) fine.x[cell] += coarse.x[parent(c, r)];
    }
  for (int i = 0; i < sweeps; ++i) fine.sweep(false);
}

void Multigrid::apply(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  Level& finest = levels_.front();
  for (std::size_t i = 0; i < cellOfUnknown_.size(); ++i)
    finest.b[cellOfUnknown_[i]] = b[static_cast<Eigen::Index>(i)];
  cycle(0);
  for (std::size_t i = 0; i < cellOfUnknown_.size(); ++i)
    x[static_cast<Eigen::Index>(i)] = finest.x[cellOfUnknown_[i]];
}

}  // namespace bedmix
