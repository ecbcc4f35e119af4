// SPDX-License-Identifier: MIT
#include "engine/gas/multigrid.h"

#include <utility>

namespace bedmix {

namespace {

constexpr int worthSharing = 1000;  // cells of a level; the first member alone sees to smaller ones
// Jacobi's damping: 1 / (1.125 +- 0.875 cos(pi/4)), for eigenvalues of D^-1 A between 1/4 and 2.
constexpr float firstDamping = 0.57348f, secondDamping = 1.97512f;

}  // namespace

Multigrid::Multigrid(const FaceLayout& layout) {
  LevelAxis across, up;
  across.size = layout.width;
  up.size = layout.height;
  levels_.emplace_back(std::move(across), std::move(up));
  while (levels_.back().cells() > 1) levels_.push_back(levels_.back().coarser());
  // Which cells are coupled does not change.
  Member alone;
  prepare(alone, layout.solved);
  for (std::size_t l = 1; l < levels_.size(); ++l) levels_[l].updateShares();
}

void Multigrid::prepare(Member& member, const std::vector<double>& conductance) {
  GridLevel& finest = levels_.front();
  const std::size_t frame = conductance.size() / 2;
  const Range mine = finest.places(member.share(finest.rows + 1));  // the outlet's stand above the last row
  for (std::size_t c = mine.begin; c < mine.end; ++c) {
    finest.west[c] = static_cast<float>(conductance[c]);
    finest.south[c] = static_cast<float>(conductance[frame + c]);
  }
  member.wait();
  prepareFrom(member, 0);
}

void Multigrid::prepareFrom(Member& member, std::size_t l) {
  GridLevel& level = levels_[l];
  if (level.cells() < worthSharing && member.shares()) {
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
  if (level.cells() < worthSharing && member.shares()) {
    Member alone;
    if (member.first()) cycle(alone, l);
    return member.wait();
  }
  const Range mine = level.places(member.share(level.rows));
  const FrameOperator<float> a = level.matrix();
  const float *perDiagonal = level.perDiagonal.data(), *b = level.b.data();
  float *x = level.x.data(), *other = level.other.data();
  if (l + 1 == levels_.size()) {
    for (std::size_t c = mine.begin; c < mine.end; ++c) x[c] = perDiagonal[c] * b[c];
    return member.wait();
  }
  relaxTwice(a, perDiagonal, b, firstDamping, secondDamping, x, mine);
  member.wait();
  findResidual(a, b, x, other, mine);
  member.wait();
  GridLevel& coarse = levels_[l + 1];
  coarse.restrictFrom(level, member.share(coarse.rows));
  member.wait();
  cycle(member, l + 1);
  coarse.prolongTo(level, member.share(coarse.rows));
  member.wait();
  relax(a, perDiagonal, b, secondDamping, x, other, mine);
  member.wait();
  relax(a, perDiagonal, b, firstDamping, other, x, mine);
  member.wait();
}

}  // namespace bedmix
