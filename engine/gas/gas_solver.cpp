// SPDX-License-Identifier: MIT
#include "engine/gas/gas_solver.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

// SIMPLE's under-relaxation, Patankar (1980) with the pressure share that suits a transient: 1 - velocity
// share.
constexpr double relaxVelocity = 0.7;
constexpr double relaxPressure = 0.3;

}  // namespace

GasSolver::GasSolver(const Scene& scene)
    : grid_(makeGasGrid(scene)),
      layout_(makeFaceLayout(grid_)),
      momentum_(scene, layout_),
      pressureSolver_(layout_),
      scheme_(scene.gas->scheme),
      step_(scene.gas->step),
      tolerance_(scene.gas->tolerance),
      maxIterations_(scene.gas->maxIterations) {
  const std::size_t faces = layout_.faceArea.size(), cells = grid_.cells();
  fields_ = {std::vector<double>(faces), std::vector<double>(cells), std::vector<double>(cells, 1.0),
             std::vector<double>(faces, 1.0)};
  exchange_ = {std::vector<double>(faces), std::vector<double>(faces)};
  oldVoidage_ = fields_.voidage;
  imbalance_.resize(cells);
  correction_.resize(cells);
  coefficient_.resize(layout_.volumes.size());
  effect_.resize(layout_.volumes.size());
  change_.resize(faces);
  setInletFlux(grid_.inletFlux);
}

void GasSolver::setInletFlux(const std::vector<double>& superficial) {
  grid_.inletFlux = superficial;
  inflow_ = 0.0;
  for (std::size_t column = 0; column < layout_.floor.size(); ++column) {
    FloorFace& f = layout_.floor[column];
    f.flux = superficial[column] * f.area;
    inflow_ += f.flux;
  }
}

void GasSolver::startWith(const std::vector<double>& voidage) {
  fields_.voidage = voidage;
  updateFaceVoidage(layout_, fields_);
}

void GasSolver::setInflow() {
  for (const FloorFace& f : layout_.floor)
    fields_.velocity[f.face] = f.flux / (f.area * fields_.faceVoidage[f.face]);
}

GasStepReport GasSolver::advance(const std::vector<double>& voidage) {
  momentum_.beginStep(fields_);
  oldVoidage_ = fields_.voidage;
  fields_.voidage = voidage;
  updateFaceVoidage(layout_, fields_);
  setInflow();
  GasStepReport report = scheme_ == GasScheme::projection ? project() : simple();
  report.massResidual = imbalance(imbalance_);
  report.solved = report.solved && std::isfinite(report.massResidual);
  return report;
}

double GasSolver::imbalance(std::vector<double>& b) const {
  double largest = 0.0;
  const auto flux = [&](int f) { return fields_.faceVoidage[f] * fields_.velocity[f] * layout_.faceArea[f]; };
  for (int c : layout_.openCells) {
    const auto& [left, right, bottom, top] = layout_.cellFaces[c];
    const double growth = layout_.cellVolume[c] * (fields_.voidage[c] - oldVoidage_[c]) / step_;
    b[c] = flux(left) - flux(right) + flux(bottom) - flux(top) - growth;
    largest = std::max(largest, std::abs(b[c]));
    if (std::isnan(b[c])) return b[c];
  }
  return inflow_ > 0.0 ? largest / inflow_ : largest;
}

bool GasSolver::preparePressure() {
  for (std::size_t k = 0; k < layout_.volumes.size(); ++k) {
    const MomentumVolume& v = layout_.volumes[k];
    coefficient_[k] = fields_.faceVoidage[v.face] * v.area * momentum_.mobility(k);
  }
  return pressureSolver_.prepare(coefficient_);
}

void GasSolver::correct(double pressureShare) {
  pressureSolver_.solve(imbalance_, correction_);
  for (std::size_t k = 0; k < layout_.volumes.size(); ++k) {
    const MomentumVolume& v = layout_.volumes[k];
    const double beyond = v.cellPlus < 0 ? 0.0 : correction_[v.cellPlus];
    change_[v.face] = momentum_.mobility(k) * (correction_[v.cellMinus] - beyond);
    fields_.velocity[v.face] += change_[v.face];
  }
  for (int c : layout_.openCells) fields_.pressure[c] += pressureShare * correction_[c];
}

GasStepReport GasSolver::project() {
  momentum_.assemble(fields_, exchange_);
  momentum_.solve(fields_);
  if (!preparePressure()) return {.solved = false};
  imbalance(imbalance_);
  correct(1.0);
  // PISO's second corrector: what the first one changed in the neighbours.
  momentum_.neighbourEffect(change_, effect_);
  for (std::size_t k = 0; k < layout_.volumes.size(); ++k)
    fields_.velocity[layout_.volumes[k].face] += effect_[k];
  imbalance(imbalance_);
  correct(1.0);
  return {};
}

GasStepReport GasSolver::simple() {
  for (std::int64_t iteration = 0; iteration < maxIterations_; ++iteration) {
    momentum_.assemble(fields_, exchange_);
    const double momentumResidual = momentum_.residual(fields_);
    momentum_.relax(fields_, relaxVelocity);
    momentum_.solve(fields_);
    if (!preparePressure()) return {.solved = false};
    const double massResidual = imbalance(imbalance_);
    correct(relaxPressure);
    if (momentumResidual < tolerance_ && massResidual < tolerance_) return {};
  }
  return {.converged = false};
}

}  // namespace bedmix
