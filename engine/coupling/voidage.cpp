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
      solids_(points_.points()),
      atPoints_(points_.points(), 1.0),
      voidage_(grid.cells(), 1.0) {
  for (const CouplingGrid::Place& cell : points_.cells) {
    owner_.push_back(points_.point(cell));
    perVolume_.push_back(points_.particleVolume / grid.volume(cell.i, cell.j));
  }
}

void VoidageField::update(const std::vector<Vec2>& position) {
  const std::size_t n = position.size();
  blocks_.resize(blocksOf(n));
  team_.run([&](int member) {
    const Range mine = team_.share(blocks_.size(), member);
    for (std::size_t b = mine.begin; b < mine.end; ++b) {
      const Range block = blockOf(n, blocks_.size(), b);
      deposit(blocks_[b], std::span(position).subspan(block.begin, block.end - block.begin));
    }
    team_.barrier();
    addBlocks(points_.columnsOf(team_, member));
  });
  aboveGrid_ = 0;
  for (const Block& block : blocks_) aboveGrid_ += block.aboveGrid;
}

void VoidageField::deposit(Block& block, std::span<const Vec2> position) const {
  block.solids.clear(points_, position);
  depositVolume(points_, position, block.solids);
  block.aboveGrid =
      std::count_if(position.begin(), position.end(), [&](Vec2 at) { return at.y > points_.y.length; });
}

void VoidageField::addBlocks(Range columns) {
  const auto forPoints = [&](auto visit) {
    for (std::size_t row = 0; row < points_.points(); row += static_cast<std::size_t>(points_.stride))
      for (std::size_t k = row + columns.begin; k < row + columns.end; ++k) visit(k);
  };
  forPoints([&](std::size_t k) { solids_[k] = 0.0; });
  for (const Block& block : blocks_)
    block.solids.forPoints(points_, columns,
                           [&](std::size_t k, double solids) { solids_[owner_[k]] += solids; });
  forPoints([&](std::size_t k) { atPoints_[k] = 1.0 - solids_[owner_[k]] * perVolume_[k]; });
  forPoints([&](std::size_t k) {
    if (owner_[k] == static_cast<std::int32_t>(k))
      voidage_[grid_.cell(points_.cells[k].i, points_.cells[k].j)] = atPoints_[k];
  });
}

double VoidageField::lowest() const { return *std::min_element(voidage_.begin(), voidage_.end()); }

}  // namespace bedmix
