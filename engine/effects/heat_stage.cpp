// SPDX-License-Identifier: MIT
#include "engine/effects/heat_stage.h"

#include "engine/core/bed_statistics.h"
#include "engine/core/blocks.h"
#include "engine/coupling/exchange.h"
#include "engine/dem/particle_solver.h"

#include <algorithm>

namespace bedmix {

namespace {

/// In the order of ids.
std::vector<double> temperaturesAtStart(const Scene& scene, const Particles& particles) {
  const HeatSettings& heat = *scene.effects.find<HeatSettings>();
  std::vector<double> temperature(particles.size(), heat.temperature);
  if (!heat.tracerTemperature) return temperature;
  std::vector<Vec2f> position;
  const Particles byId = inOrderOfIds(particles);
  for (const Vec2 at : byId.position) position.push_back(toFloat(at));
  const std::vector<std::uint8_t> species =
      tagTracer(scene.tracer.rule, position, byId.kinds, scene.bed.width);
  for (std::size_t i = 0; i < temperature.size(); ++i)
    if (species[i] == 1) temperature[i] = *heat.tracerTemperature;
  return temperature;
}

/// Heat through contacts is taken as it is now and then: of collisions, which last about a third of T, often
/// enough to find each of them. With gas once a gas step, which is right on average.
double longestBetween(const Scene& scene) {
  constexpr double samplesOfT = 20.0;
  const double holds = longestHeatStep(scene);
  return scene.gas ? holds : std::min(holds, contactTimeScale(scene) / samplesOfT);
}

}  // namespace

std::unique_ptr<EffectStage> HeatStage::make(const EffectContext& context) {
  if (!context.scene.effects.find<HeatSettings>()) return nullptr;
  return std::make_unique<HeatStage>(context);
}

void HeatStage::Gas::resize(std::size_t particles) {
  for (auto* column : {&conductance, &right, &upper}) column->resize(particles);
  point.resize(particles);
}

HeatStage::Gas::Gas(const EffectContext& context)
    : law(context.scene),
      energy(context.scene, *context.gas, context.voidage->voidage()),
      atPoints(context.voidage->points().points()) {
  resize(context.solver.particles().size());
  const CouplingGrid& grid = context.voidage->points();
  for (std::int32_t row = 0; row < grid.rows; ++row)
    for (std::int32_t column = 0; column < grid.stride; ++column) {
      const CouplingGrid::Place at = grid.cellOf({column, row});
      cellOf.push_back(context.gas->grid().cell(at.i, at.j));
    }
}

HeatStage::HeatStage(const EffectContext& context)
    : context_(context),
      perMass_(context.scene.effects.find<HeatSettings>()->heatCapacity),
      longest_(longestBetween(context.scene)),
      contacts_(context.scene),
      temperature_(context.temperature) {
  temperature_ = temperaturesAtStart(context.scene, context.solver.particles());
  for (auto* column : {&here_, &capacity_, &flow_}) column->resize(temperature_.size());
  if (context.gas) gas_.emplace(context);
}

void HeatStage::follow(const PopulationChange& change) {
  change.apply(temperature_, [this](const PopulationChange::Newcomer& newcomer) {
    const FeedStream& stream = context_.scene.effects.find<FeedSettings>()->streams[newcomer.stream];
    return stream.temperature.value_or(context_.scene.effects.find<HeatSettings>()->temperature);
  });
  for (auto* column : {&here_, &capacity_, &flow_}) column->resize(temperature_.size());
  if (gas_) gas_->resize(temperature_.size());
}

void HeatStage::act(double passed, double) {
  const Particles& particles = context_.solver.particles();
  const Roster& roster = context_.solver.roster();
  for (std::size_t i = 0; i < here_.size(); ++i) {
    here_[i] = temperature_[roster.rowOf(particles.id[i])];
    capacity_[i] = perMass_ * particles.massOf(i);
  }
  contacts_.evaluate(context_.solver, here_, flow_, context_.team);
  for (std::size_t i = 0; i < here_.size(); ++i) here_[i] += passed * flow_[i] / capacity_[i];
  if (gas_) exchangeWithGas(passed);
  for (std::size_t i = 0; i < here_.size(); ++i) temperature_[roster.rowOf(particles.id[i])] = here_[i];
}

void HeatStage::exchangeWithGas(double passed) {
  ThreadTeam& team = context_.team;
  const CouplingGrid& grid = context_.voidage->points();
  const std::size_t n = here_.size(), blocks = blocksOf(n);
  gas_->sums.resize(blocks);
  team.run([&](int member) {
    const Range mine = team.share(blocks, member);
    for (std::size_t b = mine.begin; b < mine.end; ++b)
      giveToGas(passed, blockOf(n, blocks, b), gas_->sums[b]);
    team.barrier();
    addToCells(grid.columnsOf(team, member));
  });
  gas_->energy.advance(passed);
  for (std::size_t k = 0; k < grid.points(); ++k)
    gas_->atPoints[k] = gas_->energy.temperature()[gas_->cellOf[k]];
  team.run([&](int member) {
    const Range mine = team.share(blocks, member);
    for (std::size_t b = mine.begin; b < mine.end; ++b) takeFromGas(passed, blockOf(n, blocks, b));
  });
}

void HeatStage::giveToGas(double passed, Range block, BlockSum<Sums>& sum) {
  Particles& particles = context_.solver.particles();
  const CouplingGrid& grid = context_.voidage->points();
  const ExchangeKernel loops = context_.exchange->kernel(particles);
  sum.clear(grid, std::span(particles.position).subspan(block.begin, block.size()));
  forBatches(block, [&](ExchangeBatch& batch) {
    loops.findSlip(sum.numbering(), batch);
    const BatchShares& shares = batch.shares;
    double length[batchSize];
    for (std::size_t i = 0; i < batch.size; ++i) {
      const double radius = particles.radiusOf(batch.begin + i);
      length[i] = 1.5 * shares.coupledVolume[i] / (radius * radius);
    }
    gas_->law.conductances(passed, {batch.size, batch.voidage, batch.slip, length, &capacity_[batch.begin]},
                           &gas_->conductance[batch.begin]);
    for (std::size_t i = 0; i < batch.size; ++i) {
      const std::size_t p = batch.begin + i;
      const double right = gas_->right[p] = shares.rightVolume[i];
      const double upper = gas_->upper[p] = shares.upperVolume[i];
      gas_->point[p] = pointIndex(batch.inGrid.cell[i]);
      const auto give = [&](std::int32_t point, double share) {
        Sums& to = sum[point];
        const double conductance = gas_->conductance[p] * share;
        to.coefficient += conductance;
        to.source += conductance * here_[p];
      };
      const std::int32_t lower = pointIndex(batch.inSum.cell[i]), above = lower + sum.numbering().stride;
      give(lower, (1.0 - right) * (1.0 - upper));
      give(lower + 1, right * (1.0 - upper));
      give(above, (1.0 - right) * upper);
      give(above + 1, right * upper);
    }
  });
}

void HeatStage::addToCells(Range columns) {
  const CouplingGrid& grid = context_.voidage->points();
  const GasGrid& gasGrid = context_.gas->grid();
  std::vector<double>&coefficient = gas_->energy.coefficient(), &source = gas_->energy.source();
  grid.forCells(columns, [&](std::size_t, CouplingGrid::Place at) {
    const std::size_t cell = gasGrid.cell(at.i, at.j);
    coefficient[cell] = source[cell] = 0.0;
  });
  for (const BlockSum<Sums>& sum : gas_->sums)
    sum.forPoints(grid, columns, [&](std::size_t k, const Sums& s) {
      const std::size_t cell = gas_->cellOf[k];
      coefficient[cell] += s.coefficient;
      source[cell] += s.source;
    });
}

void HeatStage::takeFromGas(double passed, Range block) {
  const auto stride = static_cast<std::size_t>(context_.voidage->points().stride);
  for (std::size_t p = block.begin; p < block.end; ++p) {
    const double* const lower = &gas_->atPoints[gas_->point[p]];
    const double *const above = lower + stride, right = gas_->right[p];
    const double below = lower[0] + right * (lower[1] - lower[0]);
    const double around = below + gas_->upper[p] * (above[0] + right * (above[1] - above[0]) - below);
    here_[p] += passed * gas_->conductance[p] * (around - here_[p]) / capacity_[p];
  }
}

void HeatStage::fill(Frame& frame) const {
  frame.temperature.assign(temperature_.begin(), temperature_.end());
  if (gas_) frame.gas.temperature.assign(gasTemperature()->begin(), gasTemperature()->end());
}

void HeatStage::hashInto(StateHash& hash) const {
  hash.add(temperature_);
  if (gas_) hash.add(*gasTemperature());
}

void HeatStage::save(StateWriter& out) const {
  out.putAll(temperature_);
  if (gas_) gas_->energy.save(out);
}

bool HeatStage::load(StateReader& in) { return in.getAll(temperature_) && (!gas_ || gas_->energy.load(in)); }

}  // namespace bedmix
