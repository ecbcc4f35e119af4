// SPDX-License-Identifier: MIT
#include "engine/coupling/voidage.h"

#include "engine/core/blocks.h"
#include "engine/coupling/voidage_kernel.h"

#include <algorithm>

namespace bedmix {

VoidageField::VoidageField(const Scene& scene, const GasGrid& grid, ThreadTeam& team)
    : grid_(grid),
      team_(team),
      points_(scene, grid),
      voidage_(grid.cells(), 1.0),
      atPoints_(points_.points(), 1.0),
      lowestOf_(static_cast<std::size_t>(team.size())) {
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c) perVolume_.push_back(points_.particleVolume / grid.roomOf(c, r));
}

void VoidageField::update(const std::vector<Vec2>& position, const std::vector<double>& radii) {
  const std::size_t n = position.size();
  blocks_.resize(blocksOf(n));
  team_.run([&](int member) {
    const Range mine = team_.share(blocks_.size(), member);
    for (std::size_t b = mine.begin; b < mine.end; ++b) {
      const Range block = blockOf(n, blocks_.size(), b);
      deposit(blocks_[b], std::span(position).subspan(block.begin, block.end - block.begin),
              radii.empty() ? nullptr : radii.data() + block.begin);
    }
    team_.barrier();
    lowestOf_[member] = addBlocks(points_.columnsOf(team_, member));
  });
  lowest_ = *std::min_element(lowestOf_.begin(), lowestOf_.end());
  aboveGrid_ = 0;
  for (const Block& block : blocks_) aboveGrid_ += block.aboveGrid;
}

void VoidageField::deposit(Block& block, std::span<const Vec2> position, const double* radii) const {
  block.solids.clear(points_, position);
  depositVolume(points_, position, radii, block.solids);
  block.aboveGrid =
      std::count_if(position.begin(), position.end(), [&](Vec2 at) { return at.y > points_.y.length; });
}

double VoidageField::addBlocks(Range columns) {
  points_.forPoints(columns, [&](std::size_t k) { atPoints_[k] = 0.0; });
  for (const Block& block : blocks_)  // in volumes of a particle
    block.solids.forPoints(points_, columns,
                           [&](std::size_t k, double solids) { atPoints_[points_.cellOwner(k)] += solids; });
  double lowest = 1.0;
  points_.forCells(columns, [&](std::size_t k, CouplingGrid::Place at) {
    const std::size_t cell = grid_.cell(at.i, at.j);
    atPoints_[k] = 1.0 - atPoints_[k] * perVolume_[cell];
    voidage_[cell] = atPoints_[k];
    lowest = std::min(lowest, atPoints_[k]);
  });
  points_.forPoints(columns, [&](std::size_t k) { atPoints_[k] = atPoints_[points_.cellOwner(k)]; });
  return lowest;
}

}  // namespace bedmix
