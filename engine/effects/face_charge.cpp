// SPDX-License-Identifier: MIT
#include "engine/effects/face_charge.h"

#include "engine/dem/particle_solver.h"

#include <numbers>

namespace bedmix {

namespace {

/// Of cells between `faces`, m: a face's point is its own, a cell's the next one. Beyond the last there is
/// nothing that changes.
void addDistances(const std::vector<double>& faces, std::vector<double>& perSize,
                  std::vector<double>& perCentres) {
  const std::size_t cells = faces.size() - 1;
  const auto size = [&](std::size_t cell) { return faces[cell + 1] - faces[cell]; };
  for (std::size_t k = 0; k < cells; ++k) perSize.push_back(1.0 / size(k));
  perCentres.push_back(1.0 / size(0));
  for (std::size_t k = 1; k < cells; ++k) perCentres.push_back(2.0 / (size(k - 1) + size(k)));
  perCentres.push_back(1.0 / size(cells - 1));
}

/// Four points and what the right and the upper ones weigh.
struct Around {
  double lowerLeft, lowerRight, upperLeft, upperRight, right, upper;

  Around(const double* lower, std::int32_t stride, double rightShare, double upperShare)
      : lowerLeft(lower[0]),
        lowerRight(lower[1]),
        upperLeft(lower[stride]),
        upperRight(lower[stride + 1]),
        right(rightShare),
        upper(upperShare) {}

  double acrossX() const {
    return (1.0 - upper) * (lowerRight - lowerLeft) + upper * (upperRight - upperLeft);
  }
  double acrossY() const {
    return (1.0 - right) * (upperLeft - lowerLeft) + right * (upperRight - lowerRight);
  }
  double here() const {
    const double left = lowerLeft + upper * (upperLeft - lowerLeft);
    return left + right * (lowerRight + upper * (upperRight - lowerRight) - left);
  }
};

/// Out to four points, of which the gas has the velocities `lower` and onwards.
struct Spread {
  double right, upper;
  std::int32_t stride;

  void operator()(double coefficient, double source, const double* velocity, FaceSums* to,
                  double FaceSums::*coefficients, double FaceSums::*sources, std::int32_t toStride) const {
    const auto add = [&](double u, FaceSums& at, double share) {
      at.*coefficients += share * coefficient;
      at.*sources += share * (source + coefficient * u);
    };
    add(velocity[0], to[0], (1.0 - right) * (1.0 - upper));
    add(velocity[1], to[1], right * (1.0 - upper));
    add(velocity[stride], to[toStride], (1.0 - right) * upper);
    add(velocity[stride + 1], to[toStride + 1], right * upper);
  }
};

}  // namespace

FaceCharge::FaceCharge(const EffectContext& context) : context_(context) {
  const GasGrid& grid = context.gas->grid();
  addDistances(grid.x, perWidth_, perCentresX_);
  if (grid.repeats)
    perCentresX_.front() = perCentresX_.back() = 2.0 / (grid.dx(0) + grid.dx(grid.columns - 1));
  addDistances(context.gas->grid().y, perHeight_, perCentresY_);
}

const std::vector<Vec2>& FaceCharge::positions() const { return context_.solver.particles().position; }
ExchangeKernel FaceCharge::kernel() const { return context_.exchange->kernel(context_.solver.particles()); }

void FaceCharge::findFlow(const ExchangeKernel& loops, const ExchangeBatch& batch, FlowThere* flow) const {
  const std::int32_t stride = loops.grid->stride;
  for (std::size_t i = 0; i < batch.size; ++i) {
    const BatchShares& shares = batch.shares;
    const std::int32_t upright = pointIndex(batch.inGrid.uprightFace[i]);
    const std::int32_t level = pointIndex(batch.inGrid.levelFace[i]);
    const Around u(loops.uprightVelocity + upright, stride, shares.right[2 * i], shares.upperCentre[i]);
    const Around v(loops.levelVelocity + level, stride, shares.right[2 * i + 1], shares.upperFace[i]);
    const double perWidth = perWidth_[upright % stride], perCentresX = perCentresX_[level % stride];
    const double perHeight = perHeight_[level / stride], perCentresY = perCentresY_[upright / stride];
    flow[i] = {{u.here(), v.here()},
               {perWidth * u.acrossX(), perCentresX * v.acrossX()},
               {perCentresY * u.acrossY(), perHeight * v.acrossY()}};
  }
}

void FaceCharge::deposit(const ExchangeKernel& loops, const ExchangeBatch& batch, const Given* given,
                         BlockSum<FaceSums>& sum) {
  const std::int32_t stride = loops.grid->stride, toStride = sum.numbering().stride;
  for (std::size_t i = 0; i < batch.size; ++i) {
    const BatchShares& shares = batch.shares;
    const Given& g = given[i];
    Spread{shares.right[2 * i], shares.upperCentre[i], stride}(
        g.coefficient, g.source.x, loops.uprightVelocity + pointIndex(batch.inGrid.uprightFace[i]),
        &sum[pointIndex(batch.inSum.uprightFace[i])], &FaceSums::uprightCoefficient, &FaceSums::uprightSource,
        toStride);
    Spread{shares.right[2 * i + 1], shares.upperFace[i], stride}(
        g.coefficient, g.source.y, loops.levelVelocity + pointIndex(batch.inGrid.levelFace[i]),
        &sum[pointIndex(batch.inSum.levelFace[i])], &FaceSums::levelCoefficient, &FaceSums::levelSource,
        toStride);
  }
}

double FaceCharge::coupledShare(const ExchangeBatch& batch, std::size_t i) const {
  const double radius = context_.solver.particles().radiusOf(batch.begin + i);
  return batch.shares.coupledVolume[i] / (4.0 / 3.0 * std::numbers::pi * radius * radius * radius);
}

}  // namespace bedmix
