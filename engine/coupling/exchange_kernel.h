// SPDX-License-Identifier: MIT
#pragma once

#include "engine/coupling/batch.h"
#include "engine/coupling/coupling_grid.h"
#include "engine/coupling/point_box.h"
#include "engine/dem/particles.h"

#include <vector>

namespace bedmix {

/// The gas at the points of the grid.
struct GasAtPoints {
  std::vector<double> uprightVelocity, levelVelocity;  // m/s
  std::vector<Vec2> pressureGradient;                  // Pa/m
};

/// What particles give to the faces at a point: drag on the gas = source - coefficient * its velocity.
struct FaceSums {
  double uprightCoefficient = 0.0, uprightSource = 0.0;  // kg/s, N
  double levelCoefficient = 0.0, levelSource = 0.0;
};

/// A batch of particles amid the gas.
struct ExchangeBatch {
  std::size_t begin = 0, size = 0;
  BatchShares shares;
  PointIndices gave;  // points of the sum they give to
  alignas(64) double voidage[batchSize];
  alignas(64) double slip[batchSize];  // m/s
  alignas(64) double drag[batchSize];  // per volume of particles and slip, kg/(m3 s)
};

/// Shares, voidage and slip of the batch.
void findSlip(const CouplingGrid& grid, const GasAtPoints& gas, const std::vector<double>& voidage,
              const Particles& particles, Numbering sum, ExchangeBatch& batch);

/// Sets drag coefficients and foreseen places from the batch's drag and gives to the gas what is due.
void giveDrag(const CouplingGrid& grid, double gasStep, const ExchangeBatch& batch, Particles& particles,
              BlockSum<FaceSums>& sum);

/// Sets the external forces of a batch whose drag coefficients are set.
void takeForces(const CouplingGrid& grid, const GasAtPoints& gas, Particles& particles, ExchangeBatch& batch);

}  // namespace bedmix
