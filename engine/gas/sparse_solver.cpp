// SPDX-License-Identifier: MIT
#include "engine/gas/sparse_solver.h"

#include <Eigen/SparseCholesky>

#include <algorithm>

namespace bedmix {

struct SparseSolver::Matrix {
  std::vector<int> unknown;           // of each cell, -1 where blocked
  Eigen::SparseMatrix<double> lower;  // triangle
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factorization;
  Eigen::VectorXd b, x;
};

SparseSolver::SparseSolver(const FaceLayout& layout) : layout_(layout), matrix_(std::make_unique<Matrix>()) {
  Matrix& m = *matrix_;
  const auto n = static_cast<int>(layout.openCells.size());
  m.unknown.assign(layout.cellVolume.size(), -1);
  for (int i = 0; i < n; ++i) m.unknown[layout.openCells[i]] = i;
  m.lower.resize(n, n);
  m.b.resize(n);
}
SparseSolver::~SparseSolver() = default;

bool SparseSolver::solve(const std::vector<double>& conductance, const std::vector<double>& b,
                         std::vector<double>& p) {
  Matrix& m = *matrix_;
  m.entries.clear();
  for (const MomentumVolume& v : layout_.volumes) {
    const double c = conductance[v.face];
    const int minus = m.unknown[v.cellMinus];
    m.entries.emplace_back(minus, minus, c);
    if (v.cellPlus < 0) continue;
    const int plus = m.unknown[v.cellPlus];
    m.entries.emplace_back(plus, plus, c);
    m.entries.emplace_back(std::max(minus, plus), std::min(minus, plus), -c);
  }
  m.lower.setFromTriplets(m.entries.begin(), m.entries.end());
  m.factorization.compute(m.lower);
  if (m.factorization.info() != Eigen::Success) return false;

  const auto place = [this](int cell) { return layout_.at(cell % layout_.columns, cell / layout_.columns); };
  for (const int cell : layout_.openCells) m.b[m.unknown[cell]] = b[place(cell)];
  m.x = m.factorization.solve(m.b);
  if (!m.x.allFinite()) return false;
  for (const int cell : layout_.openCells) p[place(cell)] = m.x[m.unknown[cell]];
  return true;
}

}  // namespace bedmix
