// SPDX-License-Identifier: MIT
#pragma once

#include "engine/coupling/batch.h"
#include "engine/coupling/coupling_grid.h"
#include "engine/coupling/point_box.h"

#include <algorithm>

namespace bedmix {

/// What a batch of particles gives to the faces at a point: drag on the gas = source - coefficient *
/// velocity.
struct FaceSums {
  double uprightCoefficient = 0.0, uprightSource = 0.0;  // kg/s, N
  double levelCoefficient = 0.0, levelSource = 0.0;
};

/// A batch of particles amid the gas.
struct ExchangeBatch {
  std::size_t begin = 0, size = 0;
  BatchShares shares;
  PointIndices inGrid, inSum;
  alignas(64) double voidage[batchSize];
  /// m/s; where particles differ, such as gives one of the grid's diameter the same Reynolds number.
  alignas(64) double slip[batchSize];
  /// Of one of the grid's diameter, per volume of particles and slip, kg/(m3 s). All laws are the same
  /// function of voidage and Reynolds number over the square of the diameter.
  alignas(64) double drag[batchSize];
};

/// Calls body(batch) for the batches of a block.
template <class Body>
void forBatches(Range block, const Body& body) {
  ExchangeBatch batch;
  for (batch.begin = block.begin; batch.begin < block.end; batch.begin += batch.size) {
    batch.size = std::min(batchSize, block.end - batch.begin);
    body(batch);
  }
}

/// The loops over the particles of a batch, in vectors.
struct ExchangeKernel {
  const CouplingGrid* grid = nullptr;
  double gasStep = 0.0;  // s
  // Per point.
  const double *uprightVelocity = nullptr, *levelVelocity = nullptr;  // of the gas, m/s
  const double* voidage = nullptr;
  const Vec2* pressureGradient = nullptr;  // Pa/m
  // Per particle; see Particles.
  const double* radii = nullptr;  // null where all are alike
  const Vec2 *position = nullptr, *velocity = nullptr;
  Vec2 *external = nullptr, *foreseen = nullptr;
  double* drag = nullptr;

  /// Shares, indices in the grid and in a sum, voidage and slip of the batch.
  void findSlip(Numbering sum, ExchangeBatch& batch) const;
  /// Sets drag coefficients from the batch's drag and foreseen places, and gives to the gas what is due.
  void giveDrag(const ExchangeBatch& batch, BlockSum<FaceSums>& sum) const;
  /// Sets the external forces of the batch, whose drag coefficients are set.
  void takeForces(ExchangeBatch& batch) const;
};

}  // namespace bedmix
