// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/blocks.h"
#include "engine/coupling/exchange.h"
#include "engine/effects/effect_stage.h"

#include <vector>

namespace bedmix {

/// The gas at a particle: its velocity as drag sees it, m/s, and how that changes in space, 1/s.
struct FlowThere {
  Vec2 velocity, perX, perY;

  double vorticity() const { return perX.y - perY.x; }  // counter-clockwise
};

/// What an effect of the gas on particles takes from the gas's faces and gives to them, with the weights of
/// the drag: a force on the gas is source - coefficient * what its velocity gains. Sums go block by block, so
/// that they do not depend on threads.
class FaceCharge {
 public:
  /// What a particle gives.
  struct Given {
    double coefficient = 0.0;  // kg/s
    Vec2 source;               // N
  };
  /// The context must have gas; what it refers to must outlive this.
  explicit FaceCharge(const EffectContext& context);

  /// Calls body(batch, flow, given), with arrays of FlowThere and Given, for each batch of particles, and
  /// gives to the faces what it sets. The flow is that which Exchange has seen last.
  template <class Body>
  void charge(MomentumExchange& exchange, const Body& body) {
    forBlocks([&](Range block, BlockSum<FaceSums>& sum) {
      forFlows(block, sum, [&](const ExchangeBatch& batch, const FlowThere* flow) {
        Given given[batchSize];
        body(batch, flow, given);
        deposit(kernel(), batch, given, sum);
      });
    });
    context_.team.run([&](int member) {
      const Range columns = context_.voidage->points().columnsOf(context_.team, member);
      context_.exchange->addToFaces(sums_, columns, exchange);
    });
  }
  /// Calls body(batch, flow) for each batch.
  template <class Body>
  void visit(const Body& body) {
    forBlocks([&](Range block, BlockSum<FaceSums>& sum) { forFlows(block, sum, body); });
  }
  /// How much of the i-th of a batch is coupled to the gas.
  double coupledShare(const ExchangeBatch& batch, std::size_t i) const;

 private:
  template <class Body>
  void forBlocks(const Body& body) {
    const std::size_t n = positions().size(), blocks = blocksOf(n);
    sums_.resize(blocks);
    context_.team.run([&](int member) {
      const Range mine = context_.team.share(blocks, member);
      for (std::size_t b = mine.begin; b < mine.end; ++b) body(blockOf(n, blocks, b), sums_[b]);
    });
  }
  template <class Body>
  void forFlows(Range block, BlockSum<FaceSums>& sum, const Body& body) {
    const ExchangeKernel loops = kernel();
    sum.clear(context_.voidage->points(),
              std::span(positions()).subspan(block.begin, block.end - block.begin));
    forBatches(block, [&](ExchangeBatch& batch) {
      FlowThere flow[batchSize];
      loops.findSlip(sum.numbering(), batch);
      findFlow(loops, batch, flow);
      body(std::as_const(batch), flow);
    });
  }
  const std::vector<Vec2>& positions() const;
  ExchangeKernel kernel() const;
  void findFlow(const ExchangeKernel& loops, const ExchangeBatch& batch, FlowThere* flow) const;
  static void deposit(const ExchangeKernel& loops, const ExchangeBatch& batch, const Given* given,
                      BlockSum<FaceSums>& sum);

  const EffectContext context_;
  std::vector<BlockSum<FaceSums>> sums_;
  /// Per column or row of points, from it to the next: between faces and between centres, 1/m.
  std::vector<double> perWidth_, perHeight_, perCentresX_, perCentresY_;
};

}  // namespace bedmix
