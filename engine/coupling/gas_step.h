// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/core/state_bytes.h"
#include "engine/gas/gas_solver.h"

#include <vector>

namespace bedmix {

/// Chooses the gas steps where a scene leaves them to it (gas.step = "auto"). What gas and particles give
/// each other is held over a gas step; how much it changes from one to the next, of all that there is, tells
/// how long a step may be for gas.error of it to be missed. Never longer than longestGasStep(), nor than the
/// gas takes for courantLimit() of a cell, and at most twice the last one. Chosen from the state of the gas
/// alone.
class GasStep {
 public:
  /// Cells that it lets the gas pass in a step.
  static double courantLimit(const GasSettings& settings);

  /// Begins with a hundredth of what the gas that enters takes for that.
  GasStep(const Scene& scene, const GasSolver& gas);

  /// The longest that the coming gas step may be, s.
  double longest() const { return longest_; }
  /// To be called where what enters changes, to `fastest` m/s at most: the coming step is no longer than that
  /// takes for courantLimit() of a cell.
  void expect(const GasSolver& gas, double fastest);
  /// To be called after a gas step: the drag on the gas alone, how the step went, its length and that of the
  /// one before, s.
  void observe(const GasSolver& gas, const MomentumExchange& drag, const GasStepReport& report, double step,
               double before);

  void save(StateWriter& out) const;
  /// False where `in` is not what save() wrote of one of the same scene, or of one with other values.
  [[nodiscard]] bool load(StateReader& in);

 private:
  double allowed_;            // relative
  double courantLimit_;       // cells
  double bound_;              // s
  double longest_;            // s
  double rate_ = 0.0;         // relative change of the drag in a second
  std::vector<double> drag_;  // on the gas, per face, N; zero before the first step
};

}  // namespace bedmix
