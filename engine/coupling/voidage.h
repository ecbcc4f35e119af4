// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"
#include "engine/core/scene.h"
#include "engine/coupling/grid_axis.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace bedmix {

/// Where a particle's volume lies: up to four cells and the share of the volume in each. The shares add up to
/// `coupling`, which is 1 inside the bed and tapers to 0 towards an open top.
struct VolumeShares {
  std::array<std::int32_t, 4> cell{};
  std::array<double, 4> share{};
  double coupling = 0.0;
};

/// Spreads each particle over a square of one diameter and cuts that by the cells: volume is conserved to
/// round-off and the voidage changes continuously in time, which d(eps)/dt in the continuity equation needs
/// (counting centres makes the pressure spike). The voidage is three-dimensional: spheres in a slab of the
/// bed's thickness. What would fall outside the side walls stays in the wall cell, what dips into blocked
/// cells goes to the lowest open cell of the column. Cells must not be smaller than a diameter (the scene
/// reader sees to it).
class VoidageField {
 public:
  /// `grid` must outlive the field.
  VoidageField(const Scene& scene, const GasGrid& grid);

  void update(std::span<const double> x, std::span<const double> y);

  const std::vector<double>& voidage() const { return voidage_; }  // per cell; 1 in blocked cells
  const std::vector<VolumeShares>& shares() const { return shares_; }
  double lowest() const;
  /// Particles whose centre is above the gas grid.
  std::int64_t aboveGrid() const { return aboveGrid_; }

 private:
  double coupling(double y) const;

  const GasGrid& grid_;
  GridAxis columns_, rows_;
  double radius_, particleVolume_, taperFrom_, top_;
  std::vector<VolumeShares> shares_;
  std::vector<double> solids_, voidage_;
  std::int64_t aboveGrid_ = 0;
};

}  // namespace bedmix
