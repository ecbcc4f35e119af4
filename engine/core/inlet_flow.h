// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"

#include <vector>

namespace bedmix {

/// What the gas enters by where an inlet pulses or follows a schedule. A function of the time alone: nothing
/// of it is state.
class InletFlow {
 public:
  /// Whether any inlet of a scene with gas changes in time.
  static bool changes(const Scene& scene);

  /// Of a grid as makeGasGrid() gives it.
  InletFlow(const Scene& scene, const GasGrid& grid);

  /// Mean over [from, from + length], s, as GasGrid::inletFlux has it; a schedule counts as in the middle.
  /// Valid until the next call.
  const std::vector<double>& over(double from, double length);
  /// The longest gas step, s, that tells a pulse.
  double longestStep() const { return longestStep_; }
  /// The fastest that any inlet ever is, m/s.
  double fastest() const { return fastest_; }

 private:
  /// What an inlet's velocity gives a column.
  struct Part {
    std::size_t inlet, column;
    double flux;  // m/s, at its mean velocity
  };

  std::vector<Inlet> inlets_;
  std::vector<Part> parts_;
  std::vector<double> factors_, flux_;
  double longestStep_, fastest_;
};

}  // namespace bedmix
