// SPDX-License-Identifier: MIT
#include "engine/gas/momentum.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

/// Patankar's power law: the share of diffusion that is left at a cell Peclet number.
double powerLaw(double peclet) {
  const double left = 1.0 - 0.1 * peclet;
  if (left <= 0.0) return 0.0;
  const double squared = left * left;
  return squared * squared * left;
}

constexpr double sweepTolerance = 1e-11;  // of the largest velocity, change per sweep
constexpr int maxSweeps = 100;

}  // namespace

MomentumSystem::MomentumSystem(const Scene& scene, const FaceLayout& layout)
    : layout_(layout),
      density_(scene.gas->density),
      viscosity_(scene.gas->viscosity),
      step_(scene.gas->step),
      theta_(scene.gas->timeScheme == TimeScheme::crankNicolson ? 0.5 : 1.0),
      gravity_(scene.gravity),
      flux_(layout.faceArea.size()),
      oldPart_(layout.volumes.size()),
      side_(layout.volumes.size()),
      diagonal_(layout.volumes.size()),
      rhs_(layout.volumes.size()),
      mobility_(layout.volumes.size()) {}

void MomentumSystem::sideCoefficients(const GasFields& gas, std::vector<std::array<double, 4>>& a) const {
  for (std::size_t k = 0; k < layout_.volumes.size(); ++k) {
    const MomentumVolume& volume = layout_.volumes[k];
    const double voidage = gas.faceVoidage[volume.face];
    for (int s = 0; s < 4; ++s) {
      const MomentumSide& side = volume.sides[s];
      const double out = 0.5 * side.outward * (flux_[side.fluxA] + flux_[side.fluxB]);
      const double otherVoidage =
          side.neighbour == layout_.zeroFace ? voidage : gas.faceVoidage[side.neighbour];
      const double diffusion = viscosity_ * 0.5 * (voidage + otherVoidage) * side.conductance;
      const double peclet = diffusion > 0.0 ? std::abs(out) / diffusion : 10.0;
      a[k][s] = diffusion * powerLaw(peclet) + std::max(-out, 0.0);
    }
  }
}

void MomentumSystem::beginStep(const GasFields& gas) {
  oldVelocity_ = gas.velocity;
  oldVoidage_ = gas.faceVoidage;
  if (theta_ == 1.0) return;
  for (std::size_t f = 0; f < flux_.size(); ++f)
    flux_[f] = density_ * gas.faceVoidage[f] * gas.velocity[f] * layout_.faceArea[f];
  sideCoefficients(gas, side_);
  for (std::size_t k = 0; k < layout_.volumes.size(); ++k) {
    const MomentumVolume& volume = layout_.volumes[k];
    double sum = 0.0;
    for (int s = 0; s < 4; ++s)
      sum += side_[k][s] * (gas.velocity[volume.sides[s].neighbour] - gas.velocity[volume.face]);
    oldPart_[k] = (1.0 - theta_) * sum;
  }
}

void MomentumSystem::assemble(const GasFields& gas, const MomentumExchange& exchange) {
  for (std::size_t f = 0; f < flux_.size(); ++f)
    flux_[f] = density_ * gas.faceVoidage[f] * gas.velocity[f] * layout_.faceArea[f];
  sideCoefficients(gas, side_);
  for (std::size_t k = 0; k < layout_.volumes.size(); ++k) {
    const MomentumVolume& volume = layout_.volumes[k];
    const int f = volume.face;
    const double inertia = density_ * oldVoidage_[f] * volume.volume / step_;
    double sum = 0.0;
    for (double& a : side_[k]) sum += a *= theta_;
    diagonal_[k] = inertia + sum + exchange.coefficient[f];
    rhs_[k] = inertia * oldVelocity_[f] + oldPart_[k] + exchange.source[f];
    if (volume.vertical) rhs_[k] -= density_ * gas.faceVoidage[f] * volume.volume * gravity_;
    mobility_[k] = gas.faceVoidage[f] * volume.area / diagonal_[k];
  }
}

void MomentumSystem::relax(const GasFields& gas, double factor) {
  for (std::size_t k = 0; k < layout_.volumes.size(); ++k) {
    const int f = layout_.volumes[k].face;
    rhs_[k] += (1.0 / factor - 1.0) * diagonal_[k] * gas.velocity[f];
    diagonal_[k] /= factor;
    mobility_[k] *= factor;
  }
}

double MomentumSystem::pressureForce(std::size_t k, const GasFields& gas) const {
  const MomentumVolume& volume = layout_.volumes[k];
  const double beyond = volume.cellPlus < 0 ? 0.0 : gas.pressure[volume.cellPlus];
  return gas.faceVoidage[volume.face] * volume.area * (gas.pressure[volume.cellMinus] - beyond);
}

double MomentumSystem::residual(const GasFields& gas) const {
  double error = 0.0, scale = 0.0;
  for (std::size_t k = 0; k < layout_.volumes.size(); ++k) {
    const MomentumVolume& volume = layout_.volumes[k];
    double sum = rhs_[k] + pressureForce(k, gas);
    for (int s = 0; s < 4; ++s) sum += side_[k][s] * gas.velocity[volume.sides[s].neighbour];
    const double own = diagonal_[k] * gas.velocity[volume.face];
    error += std::abs(sum - own);
    scale += std::abs(own);
  }
  return scale > 0.0 ? error / scale : error;
}

int MomentumSystem::solve(GasFields& gas) const {
  const auto n = static_cast<std::ptrdiff_t>(layout_.volumes.size());
  for (int sweep = 1; sweep <= maxSweeps; ++sweep) {
    double change = 0.0, largest = 0.0;
    const bool forward = sweep % 2 == 1;
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(forward ? i : n - 1 - i);
      const MomentumVolume& volume = layout_.volumes[k];
      double sum = rhs_[k] + pressureForce(k, gas);
      for (int s = 0; s < 4; ++s) sum += side_[k][s] * gas.velocity[volume.sides[s].neighbour];
      // A side that is its own neighbour (zero gradient) stands in the diagonal and in the sum alike.
      const double updated = sum / diagonal_[k];
      change = std::max(change, std::abs(updated - gas.velocity[volume.face]));
      largest = std::max(largest, std::abs(updated));
      gas.velocity[volume.face] = updated;
    }
    if (change <= sweepTolerance * largest) return sweep;
  }
  return maxSweeps;
}

void MomentumSystem::neighbourEffect(const std::vector<double>& change, std::vector<double>& effect) const {
  for (std::size_t k = 0; k < layout_.volumes.size(); ++k) {
    double sum = 0.0;
    for (int s = 0; s < 4; ++s) sum += side_[k][s] * change[layout_.volumes[k].sides[s].neighbour];
    effect[k] = sum / diagonal_[k];
  }
}

}  // namespace bedmix
