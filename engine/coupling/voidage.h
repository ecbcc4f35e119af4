// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"
#include "engine/core/scene.h"
#include "engine/core/thread_team.h"
#include "engine/core/vec2.h"
#include "engine/coupling/coupling_grid.h"
#include "engine/coupling/point_box.h"

#include <cstdint>
#include <vector>

namespace bedmix {

/// Spreads each particle over a square of its diameter and cuts that by the cells: volume is conserved to
/// round-off and the voidage changes continuously in time, which d(eps)/dt in the continuity equation needs
/// (counting centres makes the pressure spike). The voidage is three-dimensional: spheres in a slab of the
/// bed's thickness. What would fall outside the side walls stays in the wall cell, what dips into blocked
/// cells goes to the lowest open cell of the column. Cells must not be smaller than the largest diameter (the
/// scene reader sees to it).
class VoidageField {
 public:
  /// `grid` and `team` must outlive the field.
  VoidageField(const Scene& scene, const GasGrid& grid, ThreadTeam& team);

  /// `radii` (m) are empty where all are alike.
  void update(const std::vector<Vec2>& position, const std::vector<double>& radii = {});

  const std::vector<double>& voidage() const { return voidage_; }  // per cell; 1 in blocked cells
  double lowest() const { return lowest_; }
  /// Particles whose centre is above the gas grid.
  std::int64_t aboveGrid() const { return aboveGrid_; }
  /// The grid as particles see it, and the voidage at its cells' points.
  const CouplingGrid& points() const { return points_; }
  const std::vector<double>& atPoints() const { return atPoints_; }

 private:
  struct Block {
    BlockSum<double> solids;  // in volumes of the grid's particle
    std::int64_t aboveGrid = 0;
  };
  void deposit(Block& block, std::span<const Vec2> position, const double* radii) const;
  /// Voidage in a part of the points' columns; returns the lowest there.
  double addBlocks(Range columns);

  const GasGrid& grid_;
  ThreadTeam& team_;
  CouplingGrid points_;
  std::vector<Block> blocks_;
  std::vector<double> perVolume_, voidage_;  // per cell: share of it that one particle fills
  std::vector<double> atPoints_;
  std::vector<double> lowestOf_;  // per member of the team
  double lowest_ = 1.0;
  std::int64_t aboveGrid_ = 0;
};

}  // namespace bedmix
