// SPDX-License-Identifier: MIT
#include "engine/gas/pressure_solver.h"

#include "engine/gas/multigrid.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr std::size_t largestDirect = 20000;  // cells; beyond it fill-in costs more than iterating
constexpr double iterativeTolerance = 1e-12;

using Sparse = Eigen::SparseMatrix<double>;  // lower triangle

/// Multigrid in the shape Eigen's solvers ask of a preconditioner. It is prepared with the coefficients
/// themselves, so the matrix it is offered says nothing new.
class CyclePreconditioner {
 public:
  using StorageIndex = int;
  enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic };

  CyclePreconditioner& analyzePattern(const Sparse&) { return *this; }
  CyclePreconditioner& factorize(const Sparse&) { return *this; }
  CyclePreconditioner& compute(const Sparse&) { return *this; }
  Eigen::ComputationInfo info() const { return Eigen::Success; }
  const Eigen::VectorXd& solve(const Eigen::VectorXd& b) const {
    result_.resize(b.size());
    multigrid.apply(b, result_);
    return result_;
  }

  Multigrid multigrid;

 private:
  mutable Eigen::VectorXd result_;
};

}  // namespace

struct PressureSolver::Matrix {
  const FaceLayout& layout;
  std::vector<int> unknownOfCell;
  Sparse a;
  std::vector<double*> diagonal;  // per unknown
  std::vector<double*> between;   // per volume; null at the outlet
  Eigen::VectorXd b, x;
  bool direct = true;
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower> factorization;
  Eigen::ConjugateGradient<Sparse, Eigen::Lower, CyclePreconditioner> iteration;

  explicit Matrix(const FaceLayout& l) : layout(l), unknownOfCell(l.cellVolume.size(), -1) {
    const auto n = static_cast<int>(l.openCells.size());
    for (int i = 0; i < n; ++i) unknownOfCell[l.openCells[i]] = i;
    std::vector<Eigen::Triplet<double>> pattern;
    for (int i = 0; i < n; ++i) pattern.emplace_back(i, i, 1.0);
    for (const MomentumVolume& v : l.volumes)
      if (v.cellPlus >= 0) pattern.emplace_back(row(v), column(v), 0.0);
    a.resize(n, n);
    a.setFromTriplets(pattern.begin(), pattern.end());
    a.makeCompressed();
    for (int i = 0; i < n; ++i) diagonal.push_back(&a.coeffRef(i, i));
    for (const MomentumVolume& v : l.volumes)
      between.push_back(v.cellPlus >= 0 ? &a.coeffRef(row(v), column(v)) : nullptr);
    b.setZero(n);
    x.setZero(n);
    direct = l.openCells.size() <= largestDirect;
    if (direct) factorization.analyzePattern(a);
    if (!direct) iteration.preconditioner().multigrid = Multigrid(l, unknownOfCell);
    iteration.setTolerance(iterativeTolerance);
  }

  int minus(const MomentumVolume& v) const { return unknownOfCell[v.cellMinus]; }
  int plus(const MomentumVolume& v) const { return unknownOfCell[v.cellPlus]; }
  int row(const MomentumVolume& v) const { return std::max(minus(v), plus(v)); }
  int column(const MomentumVolume& v) const { return std::min(minus(v), plus(v)); }
};

PressureSolver::PressureSolver(const FaceLayout& layout) : matrix_(std::make_unique<Matrix>(layout)) {}
PressureSolver::~PressureSolver() = default;

bool PressureSolver::prepare(const std::vector<double>& coefficient) {
  if (!std::all_of(coefficient.begin(), coefficient.end(), [](double c) { return std::isfinite(c); }))
    return false;
  Matrix& m = *matrix_;
  for (double* d : m.diagonal) *d = 0.0;
  for (std::size_t k = 0; k < m.layout.volumes.size(); ++k) {
    const MomentumVolume& v = m.layout.volumes[k];
    *m.diagonal[m.minus(v)] += coefficient[k];
    if (!m.between[k]) continue;
    *m.diagonal[m.plus(v)] += coefficient[k];
    *m.between[k] = -coefficient[k];
  }
  if (m.direct) {
    m.factorization.factorize(m.a);
    return m.factorization.info() == Eigen::Success;
  }
  m.iteration.preconditioner().multigrid.prepare(m.layout, coefficient);
  m.iteration.compute(m.a);
  return true;
}

int PressureSolver::iterations() const {
  return matrix_->direct ? 0 : static_cast<int>(matrix_->iteration.iterations());
}

void PressureSolver::solve(const std::vector<double>& b, std::vector<double>& p) {
  Matrix& m = *matrix_;
  const std::vector<int>& cells = m.layout.openCells;
  for (std::size_t i = 0; i < cells.size(); ++i) m.b[static_cast<Eigen::Index>(i)] = b[cells[i]];
  if (m.direct)
    m.x = m.factorization.solve(m.b);
  else
    m.x = m.iteration.solve(m.b);
  std::fill(p.begin(), p.end(), 0.0);
  for (std::size_t i = 0; i < cells.size(); ++i) p[cells[i]] = m.x[static_cast<Eigen::Index>(i)];
}

}  // namespace bedmix
