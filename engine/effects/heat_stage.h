// SPDX-License-Identifier: MIT
#pragma once

#include "engine/coupling/point_box.h"
#include "engine/effects/effect_stage.h"
#include "engine/effects/heat_contacts.h"
#include "engine/effects/heat_gas.h"
#include "engine/effects/heat_laws.h"

#include <memory>
#include <optional>
#include <vector>

namespace bedmix {

/// Temperatures of particles, each the same throughout, and of the gas:
///   m c dT/dt = h A (T_gas - T) + heat through contacts,
/// h after Gunn (1978); see ConvectionLaw, ConductionLaw and GasHeat. Once a gas step, or, without gas, as
/// often as contacts need it, contacts are taken as they are at that instant. A particle exchanges heat with
/// the cells by the shares of its volume in them, with the new temperature of the gas; what one gives is what
/// the other gets, to round-off.
class HeatStage final : public EffectStage {
 public:
  /// None where the scene has no heat.
  static std::unique_ptr<EffectStage> make(const EffectContext& context);
  explicit HeatStage(const EffectContext& context);

  double longestStep() const override { return longest_; }
  void follow(const PopulationChange& change) override;
  void act(double passed, double step) override;
  void fill(Frame& frame) const override;
  void hashInto(StateHash& hash) const override;
  void save(StateWriter& out) const override;
  [[nodiscard]] bool load(StateReader& in) override;

  /// Of the gas; null without.
  const std::vector<double>* gasTemperature() const { return gas_ ? &gas_->energy.temperature() : nullptr; }

 private:
  struct Sums {
    double coefficient = 0.0, source = 0.0;  // W/K, W
  };
  /// The gas and what ties it to the particles.
  struct Gas {
    explicit Gas(const EffectContext& context);
    void resize(std::size_t particles);

    ConvectionLaw law;
    GasHeat energy;
    std::vector<BlockSum<Sums>> sums;
    // Per particle in memory: to the gas, W/K; the lower left one of its cells' points and the shares in the
    // right and upper ones.
    std::vector<double> conductance, right, upper;
    std::vector<std::int32_t> point;
    // Per point: the cell of the gas that owns it, and its temperature, K.
    std::vector<std::size_t> cellOf;
    std::vector<double> atPoints;
  };
  void giveToGas(double passed, Range block, BlockSum<Sums>& sum);
  void addToCells(Range columns);
  void takeFromGas(double passed, Range block);
  void exchangeWithGas(double passed);

  const EffectContext context_;
  double perMass_;  // heat capacity of the solid, J/(kg K)
  double longest_;  // s
  ContactHeat contacts_;
  std::optional<Gas> gas_;
  std::vector<double>& temperature_;  // of the context
  // In memory: temperature, K, heat capacity, J/K, and what comes through contacts, W.
  std::vector<double> here_, capacity_, flow_;
};

}  // namespace bedmix
