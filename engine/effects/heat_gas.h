// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/core/state_bytes.h"
#include "engine/gas/gas_solver.h"

#include <array>
#include <optional>
#include <vector>

namespace bedmix {

/// The gas energy balance in the voids,
///   d(e rho c T)/dt + div(e rho c u T) = div(K grad T) + sources,
/// in the cells of the gas, implicit, with the very flows and voidages that satisfy continuity; that is
/// subtracted, so that a uniform temperature stays uniform. Convection is upwind (Patankar 1980), which no
/// sharp front survives but which makes no temperature that is not between others. K = (1 - sqrt(1 - e)) k is
/// what the particles leave of the gas's conductivity, Syamlal & Gidaspow (1985), AIChE J. 31:127. What
/// enters has the inlet's temperature, what comes back through the outlet that of the cell it comes to.
class GasHeat {
 public:
  /// The scene must have heat; `voidage` is what the gas starts with.
  GasHeat(const Scene& scene, const GasSolver& gas, const std::vector<double>& voidage);

  const std::vector<double>& temperature() const { return temperature_; }  // per cell, K
  /// What the particles give, per cell: source - coefficient * temperature. To be filled before advance().
  std::vector<double>& coefficient() { return coefficient_; }  // W/K
  std::vector<double>& source() { return source_; }            // W
  /// To be called after each step of the gas, with what has passed since the last one, s.
  void advance(double passed);

  void save(StateWriter& out) const;
  [[nodiscard]] bool load(StateReader& in);

 private:
  /// A side of an open cell; the cell beyond, or -1.
  struct Side {
    int face = 0, beyond = -1;
    double outward = 0.0;      // 1 or -1: the face's velocity times this leaves the cell
    double perDistance = 0.0;  // area over the distance to the cell beyond, or to the wall, m
    bool isFloor = false, isOutlet = false;
  };
  struct Cell {
    int index = 0;
    double volume = 0.0;  // m3
    std::array<Side, 4> sides;
  };
  /// The balance of a cell for its change of temperature x: x = perDiagonal * (right + sum of share * x
  /// beyond).
  struct Row {
    double perDiagonal, right;
    std::array<double, 4> share;
    std::array<int, 4> beyond;  // a place that stays zero where there is none
  };
  Row row(const Cell& cell, double passed) const;
  double relax(std::size_t k);
  void solve();

  const GasSolver& gas_;
  double capacity_, conductivity_, inletTemperature_;  // J/(m3 K), W/(m K), K
  std::optional<double> wallTemperature_;
  std::vector<Cell> cells_;
  std::vector<double> temperature_, coefficient_, source_;
  std::vector<double> voidage_;  // at the last step, per cell
  std::vector<Row> rows_;        // one a cell of cells_
  std::vector<double> change_;   // per cell, K, and a zero
};

}  // namespace bedmix
