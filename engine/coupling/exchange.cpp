// SPDX-License-Identifier: MIT
#include "engine/coupling/exchange.h"

#include "engine/core/blocks.h"

#include <algorithm>

namespace bedmix {

Exchange::Exchange(const Scene& scene, const GasSolver& gas, const VoidageField& voidage, ThreadTeam& team)
    : gas_(gas),
      voidage_(voidage),
      grid_(voidage.points()),
      team_(team),
      law_(scene.gas->drag),
      properties_{scene.particles.diameter, scene.gas->density, scene.gas->viscosity},
      step_(scene.gas->step.valueOr(longestGasStep(scene))),
      uprightVelocity_(grid_.points()),
      levelVelocity_(grid_.points()),
      pressure_(grid_.points()),
      gradient_(grid_.points()) {
  for (std::int32_t j = 0; j < grid_.rows; ++j)
    for (std::int32_t i = 0; i < grid_.stride; ++i) {
      const CouplingGrid::Place upright = grid_.uprightFaceOf({i, j}), level = grid_.levelFaceOf({i, j});
      uprightFace_.push_back(gas.layout().uFace(upright.i, upright.j));
      levelFace_.push_back(gas.layout().vFace(level.i, level.j));
    }
  const GasGrid& g = gas.grid();
  const auto open = [&g](int i, int j) {
    if (g.repeats) i = g.columnAround(i);
    return i >= 0 && i < g.columns && g.open(i, j);
  };
  for (int j = 0; j < g.rows; ++j)
    for (int i = 0; i < g.columns; ++i) {
      across_.push_back(weights(open(i - 1, j), open(i + 1, j)));
      up_.push_back(weights(j > 0 && g.open(i, j - 1), j + 1 == g.rows || g.open(i, j + 1)));
    }
  perDistanceX_.assign(g.x.size(), 0.0);
  for (int i = 1; i < g.columns; ++i) perDistanceX_[i] = 2.0 / (g.dx(i - 1) + g.dx(i));
  if (g.repeats) perDistanceX_.front() = perDistanceX_.back() = 2.0 / (g.dx(0) + g.dx(g.columns - 1));
  perDistanceY_.assign(g.y.size(), 0.0);
  for (int j = 1; j < g.rows; ++j) perDistanceY_[j] = 2.0 / (g.dy(j - 1) + g.dy(j));
  perDistanceY_[g.rows] = 2.0 / g.dy(g.rows - 1);
}

Exchange::FaceWeights Exchange::weights(bool before, bool after) {
  if (before && after) return {0.5f, 0.5f};
  return {before ? 1.0f : 0.0f, after ? 1.0f : 0.0f};
}

void Exchange::copyVelocity(Range points) {
  const std::vector<double>& velocity = gas_.fields().velocity;
  for (std::size_t k = points.begin; k < points.end; ++k) {
    uprightVelocity_[k] = velocity[uprightFace_[k]];
    levelVelocity_[k] = velocity[levelFace_[k]];
  }
}

void Exchange::copyPressure(Range rows) {
  const auto columns = static_cast<std::ptrdiff_t>(gas_.grid().columns);
  for (std::size_t row = rows.begin; row < rows.end; ++row) {
    const auto j = static_cast<std::int32_t>(row);
    std::copy_n(gas_.fields().pressure.begin() + static_cast<std::ptrdiff_t>(gas_.grid().cell(0, j)), columns,
                pressure_.begin() + static_cast<std::ptrdiff_t>(grid_.point({0, j})));
    if (!gas_.grid().repeats) continue;
    pressure_[grid_.point({-1, j})] = pressure_[grid_.point({gas_.grid().columns - 1, j})];
    pressure_[grid_.point({gas_.grid().columns, j})] = pressure_[grid_.point({0, j})];
  }
}

void Exchange::findGradient(Range columns) {
  const double *const pressure = pressure_.data(), *const toLeft = perDistanceX_.data();
  const FaceWeights *const across = across_.data(), *const up = up_.data();
  Vec2* const gradient = gradient_.data();
  const std::ptrdiff_t stride = grid_.stride;
  grid_.forCells(columns, [&](std::size_t k, CouplingGrid::Place at) {
    const double *const p = pressure + k, *const below = &perDistanceY_[at.j];
    const std::size_t cell = gas_.grid().cell(at.i, at.j);
    gradient[k] = {
        across[cell].before * toLeft[at.i] * (p[0] - p[-1]) +
            across[cell].after * toLeft[at.i + 1] * (p[1] - p[0]),
        up[cell].before * below[0] * (p[0] - p[-stride]) + up[cell].after * below[1] * (p[stride] - p[0])};
  });
  grid_.forPoints(columns, [&](std::size_t k) { gradient[k] = gradient[grid_.cellOwner(k)]; });
}

ExchangeKernel Exchange::kernel(Particles& particles) const {
  return {.grid = &grid_,
          .gasStep = step_,
          .uprightVelocity = uprightVelocity_.data(),
          .levelVelocity = levelVelocity_.data(),
          .voidage = voidage_.atPoints().data(),
          .pressureGradient = gradient_.data(),
          .radii = particles.areMixed() ? particles.radii.data() : nullptr,
          .position = particles.position.data(),
          .velocity = particles.velocity.data(),
          .external = particles.external.data(),
          .foreseen = particles.foreseen.data(),
          .drag = particles.drag.data()};
}

void Exchange::evaluateDrag(Particles& particles, MomentumExchange& exchange) {
  const std::size_t n = particles.size(), faces = exchange.source.size();
  const ExchangeKernel loops = kernel(particles);
  sums_.resize(blocksOf(n));
  team_.run([&](int member) {
    copyVelocity(team_.share(grid_.points(), member));
    const Range cleared = team_.share(faces, member);
    std::fill_n(exchange.coefficient.begin() + cleared.begin, cleared.end - cleared.begin, 0.0);
    std::fill_n(exchange.source.begin() + cleared.begin, cleared.end - cleared.begin, 0.0);
    team_.barrier();
    const Range mine = team_.share(sums_.size(), member);
    for (std::size_t b = mine.begin; b < mine.end; ++b) {
      const Range block = blockOf(n, sums_.size(), b);
      BlockSum<FaceSums>& sum = sums_[b];
      sum.clear(grid_, std::span(particles.position).subspan(block.begin, block.end - block.begin));
      forBatches(block, [&](ExchangeBatch& batch) {
        loops.findSlip(sum.numbering(), batch);
        evaluateDragLaw(law_, properties_, batch.size, batch.voidage, batch.slip, batch.drag);
        loops.giveDrag(batch, sum);
      });
    }
    team_.barrier();
    addToFaces(sums_, grid_.columnsOf(team_, member), exchange);
  });
}

void Exchange::addToFaces(const std::vector<BlockSum<FaceSums>>& sums, Range columns,
                          MomentumExchange& exchange) const {
  for (const BlockSum<FaceSums>& sum : sums)
    sum.forPoints(grid_, columns, [&](std::size_t k, const FaceSums& s) {
      exchange.coefficient[uprightFace_[k]] += s.uprightCoefficient;
      exchange.source[uprightFace_[k]] += s.uprightSource;
      exchange.coefficient[levelFace_[k]] += s.levelCoefficient;
      exchange.source[levelFace_[k]] += s.levelSource;
    });
}

void Exchange::applyForces(Particles& particles) {
  const std::size_t n = particles.size(), blocks = blocksOf(n);
  const ExchangeKernel loops = kernel(particles);
  team_.run([&](int member) {
    copyVelocity(team_.share(grid_.points(), member));
    copyPressure(team_.share(static_cast<std::size_t>(gas_.grid().rows), member));
    team_.barrier();
    findGradient(grid_.columnsOf(team_, member));
    team_.barrier();
    const Range mine = team_.share(blocks, member);
    for (std::size_t b = mine.begin; b < mine.end; ++b)
      forBatches(blockOf(n, blocks, b), [&](ExchangeBatch& batch) { loops.takeForces(batch); });
  });
}

}  // namespace bedmix
