// SPDX-License-Identifier: MIT
#include "engine/gas/multigrid.h"

#include <utility>

namespace bedmix {

namespace {

constexpr int worthSharingLevel = 1000;  // cells of a level; the first member alone sees to smaller ones

}  // namespace

Multigrid::Multigrid(const FaceLayout& layout, int members) {
  LevelAxis across, up;
  across.size = layout.width;
  up.size = layout.height;
  levels_.emplace_back(std::move(across), std::move(up));
  while (levels_.back().cells() > 1) levels_.push_back(levels_.back().coarser());
  scratch_.assign(static_cast<std::size_t>(members), std::vector<float>(levels_.front().scratchSize()));
  // Which cells are coupled does not change.
  Member alone;
  prepare(alone, layout.solved);
  for (std::size_t l = 1; l < levels_.size(); ++l) levels_[l].updateShares();
}

void Multigrid::prepare(Member& member, const std::vector<double>& conductance) {
  GridLevel& finest = levels_.front();
  const std::size_t frame = conductance.size() / 2;
  const Range rows = member.share(finest.rows + 1);  // the outlet's stand above the last row
  for (int c = finest.at(0, static_cast<int>(rows.begin)); c < finest.at(0, static_cast<int>(rows.end));
       ++c) {
    finest.west[c] = static_cast<float>(conductance[c]);
    finest.south[c] = static_cast<float>(conductance[frame + static_cast<std::size_t>(c)]);
  }
  member.wait();
  prepareFrom(member, 0);
}

void Multigrid::prepareFrom(Member& member, std::size_t l) {
  GridLevel& level = levels_[l];
  if (level.cells() < worthSharingLevel && member.shares()) {
    Member alone;
    if (member.first()) prepareFrom(alone, l);
    return member.wait();
  }
  level.updateDiagonal(member.share(level.rows));
  if (l + 1 == levels_.size()) return;
  GridLevel& coarse = levels_[l + 1];
  coarse.conductLike(level, member.share(coarse.rows + 1));
  member.wait();
  prepareFrom(member, l + 1);
}

void Multigrid::cycle(Member& member, std::size_t l) {
  GridLevel& level = levels_[l];
  if (level.cells() < worthSharingLevel && member.shares()) {
    Member alone;
    if (member.first()) cycle(alone, l);
    return;
  }
  if (l + 1 == levels_.size()) {
    const int c = level.at(0, 0);
    level.x[c] = level.perDiagonal[c] * level.b[c];
    return;
  }
  GridLevel& coarse = levels_[l + 1];
  // Strips across the long side, which have the fewest neighbours.
  Patch mine{member.share(coarse.rows), {0, static_cast<std::size_t>(coarse.columns)}};
  if (coarse.columns > coarse.rows)
    mine = {{0, static_cast<std::size_t>(coarse.rows)}, member.share(coarse.columns)};
  float* const scratch = scratch_[member.index()].data();
  level.descend(coarse, mine, scratch);
  member.wait();
  cycle(member, l + 1);
  member.wait();
  level.ascend(coarse, mine, scratch);
}

}  // namespace bedmix
