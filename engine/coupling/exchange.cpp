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
      step_(scene.gas->step),
      uprightVelocity_(grid_.points()),
      levelVelocity_(grid_.points()),
      pressure_(grid_.points()),
      gradient_(grid_.points()) {
  for (const CouplingGrid::Place& at : grid_.cells) {
    cell_.push_back(static_cast<std::int32_t>(gas.grid().cell(at.i, at.j)));
    slopes_.push_back(slopes(at.i, at.j));
  }
  for (const CouplingGrid::Place& at : grid_.uprightFaces)
    uprightFace_.push_back(gas.layout().uFace(at.i, at.j));
  for (const CouplingGrid::Place& at : grid_.levelFaces) levelFace_.push_back(gas.layout().vFace(at.i, at.j));
}

Exchange::Slopes Exchange::slopes(int i, int j) const {
  const GasGrid& g = gas_.grid();
  const bool left = i > 0 && g.open(i - 1, j), right = i + 1 < g.columns && g.open(i + 1, j);
  const bool bottom = j > 0 && g.open(i, j - 1), outlet = j + 1 == g.rows;
  Slopes s;
  const double across = left && right ? 0.5 : 1.0, up = bottom ? 0.5 : 1.0;
  if (left) s.left = across / (0.5 * (g.dx(i - 1) + g.dx(i)));
  if (right) s.right = across / (0.5 * (g.dx(i) + g.dx(i + 1)));
  if (bottom) s.bottom = up / (0.5 * (g.dy(j - 1) + g.dy(j)));
  s.top = up / (outlet ? 0.5 * g.dy(j) : 0.5 * (g.dy(j) + g.dy(j + 1)));
  return s;
}

void Exchange::copyVelocity(Range points) {
  const std::vector<double>& velocity = gas_.fields().velocity;
  for (std::size_t k = points.begin; k < points.end; ++k) {
    uprightVelocity_[k] = velocity[uprightFace_[k]];
    levelVelocity_[k] = velocity[levelFace_[k]];
  }
}

void Exchange::copyPressure(Range points) {
  const std::size_t outlet = grid_.points() - static_cast<std::size_t>(grid_.stride);
  for (std::size_t k = points.begin; k < points.end; ++k)
    pressure_[k] = k < outlet ? gas_.fields().pressure[cell_[k]] : 0.0;
}

void Exchange::findGradient(Range points) {
  for (std::size_t k = points.begin; k < points.end; ++k) {
    const Slopes& s = slopes_[k];
    const double* const p = &pressure_[grid_.point(grid_.cells[k])];
    gradient_[k] = {s.left * (p[0] - p[-1]) + s.right * (p[1] - p[0]),
                    s.bottom * (p[0] - p[-grid_.stride]) + s.top * (p[grid_.stride] - p[0])};
  }
}

ExchangeKernel Exchange::kernel(Particles& particles) const {
  return {.grid = &grid_,
          .gasStep = step_,
          .uprightVelocity = uprightVelocity_.data(),
          .levelVelocity = levelVelocity_.data(),
          .voidage = voidage_.atPoints().data(),
          .pressureGradient = gradient_.data(),
          .position = particles.position.data(),
          .velocity = particles.velocity.data(),
          .external = particles.external.data(),
          .foreseen = particles.foreseen.data(),
          .drag = particles.drag.data()};
}

/// Calls body(batch) for the batches of a block.
template <class Body>
static void forBatches(Range block, const Body& body) {
  ExchangeBatch batch;
  for (batch.begin = block.begin; batch.begin < block.end; batch.begin += batch.size) {
    batch.size = std::min(batchSize, block.end - batch.begin);
    body(batch);
  }
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
    addToFaces(grid_.columnsOf(team_, member), exchange);
  });
}

void Exchange::addToFaces(Range columns, MomentumExchange& exchange) const {
  for (const BlockSum<FaceSums>& sum : sums_)
    sum.forPoints(grid_, columns, [&](std::int32_t k, const FaceSums& s) {
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
    const Range points = team_.share(grid_.points(), member);
    copyVelocity(points);
    copyPressure(points);
    team_.barrier();
    findGradient(points);
    team_.barrier();
    const Range mine = team_.share(blocks, member);
    for (std::size_t b = mine.begin; b < mine.end; ++b)
      forBatches(blockOf(n, blocks, b), [&](ExchangeBatch& batch) { loops.takeForces(batch); });
  });
}

}  // namespace bedmix
