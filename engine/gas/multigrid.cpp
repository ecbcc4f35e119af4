// SPDX-License-Identifier: MIT
#include "engine/gas/multigrid.h"

#include <algorithm>
#include <utility>

namespace bedmix {

namespace {

constexpr double weakCoupling = 0.2;  // of the other direction's: joining along it would not help
constexpr int worthSharing = 1000;    // cells of a level; the first member alone sees to smaller ones
// Jacobi's damping: 1 / (1.125 +- 0.875 cos(pi/4)), for eigenvalues of D^-1 A between 1/4 and 2.
constexpr float firstDamping = 0.57348f, secondDamping = 1.97512f;

}  // namespace

double Multigrid::Axis::sumOfSizes() const {
  double sum = 0.0;
  for (double s : size) sum += s;
  return sum;
}

double Multigrid::Axis::sumOfCouplings() const {
  double sum = 0.0;
  for (std::size_t i = 1; i < size.size(); ++i) sum += 2.0 / (size[i - 1] + size[i]);
  return sum;
}

Multigrid::Axis Multigrid::Axis::coarser(bool join) const {
  Axis coarse;
  coarse.joined = join;
  const std::size_t n = join ? (size.size() + 1) / 2 : size.size();
  const auto fineSize = [&](std::size_t i) { return i < size.size() ? size[i] : 0.0; };
  for (std::size_t i = 0; i < n; ++i)
    coarse.size.push_back(join ? fineSize(2 * i) + fineSize(2 * i + 1) : size[i]);
  coarse.conduction.assign(n + 1, 1.0);
  coarse.back.assign(n + 1, 0.0f);
  coarse.forth.assign(n + 1, 0.0f);
  if (!join) return coarse;
  for (std::size_t i = 1; i <= n; ++i) {
    // Cells beside the face; beyond the last there is the outlet, at the face itself.
    const double before = coarse.size[i - 1], behind = i < n ? coarse.size[i] : 0.0;
    const std::size_t last = std::min(2 * i, size.size()) - 1;  // fine cell before the face
    const double fineBefore = size[last], fineBehind = fineSize(2 * i);
    const double distance = 0.5 * (before + behind);
    coarse.conduction[i] = 0.5 * (fineBefore + fineBehind) / distance;
    coarse.forth[i] = static_cast<float>(0.5 * (before - fineBefore) / distance);
    coarse.back[i] = static_cast<float>(0.5 * (behind - fineBehind) / distance);
  }
  return coarse;
}

Multigrid::Level::Level(Axis a, Axis u)
    : across(std::move(a)), up(std::move(u)), columns(across.cells()), rows(up.cells()), stride(columns + 1) {
  // As in FaceLayout; one more, since restrict() looks two places ahead.
  const auto size = static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows + 3) + 1;
  for (auto* field : {&west, &south, &perDiagonal, &x, &other, &b, &toWest, &toEast, &toSouth, &toNorth})
    field->assign(size, 0.0f);
}

Range Multigrid::Level::places(const Member& member) const {
  const Range mine = member.share(rows);
  return {static_cast<std::size_t>(at(0, static_cast<int>(mine.begin))),
          static_cast<std::size_t>(at(0, static_cast<int>(mine.end)))};
}

void Multigrid::Level::updateDiagonal(Range places) {
  for (std::size_t c = places.begin; c < places.end; ++c) {
    const float diagonal = west[c] + west[c + 1] + south[c] + south[c + stride];
    perDiagonal[c] = diagonal > 0.0f ? 1.0f / diagonal : 0.0f;
  }
}

void Multigrid::Level::smooth(const std::vector<float>& from, std::vector<float>& to, float damping,
                              Range places) const {
  const float *f = from.data(), *w = west.data(), *s = south.data(), *d = perDiagonal.data(), *r = b.data();
  float* t = to.data();
  const std::ptrdiff_t n = stride;
#pragma GCC ivdep
  for (auto c = static_cast<std::ptrdiff_t>(places.begin); c < static_cast<std::ptrdiff_t>(places.end); ++c)
    t[c] = f[c] + damping * d[c] *
                      (r[c] - (w[c] * (f[c] - f[c - 1]) + w[c + 1] * (f[c] - f[c + 1]) +
                               s[c] * (f[c] - f[c - n]) + s[c + n] * (f[c] - f[c + n])));
}

void Multigrid::Level::residual(const std::vector<float>& from, std::vector<float>& to, Range places) const {
  const float *f = from.data(), *w = west.data(), *s = south.data(), *r = b.data();
  float* t = to.data();
  const std::ptrdiff_t n = stride;
#pragma GCC ivdep
  for (auto c = static_cast<std::ptrdiff_t>(places.begin); c < static_cast<std::ptrdiff_t>(places.end); ++c)
    t[c] = r[c] - (w[c] * (f[c] - f[c - 1]) + w[c + 1] * (f[c] - f[c + 1]) + s[c] * (f[c] - f[c - n]) +
                   s[c + n] * (f[c] - f[c + n]));
}

Multigrid::Multigrid(const FaceLayout& layout) {
  Axis across, up;
  across.size = layout.width;
  up.size = layout.height;
  levels_.emplace_back(std::move(across), std::move(up));
  while (levels_.back().columns * levels_.back().rows > 1) {
    const Level& fine = levels_.back();
    const double sideways = fine.across.sumOfCouplings() * fine.up.sumOfSizes();
    const double upward = fine.up.sumOfCouplings() * fine.across.sumOfSizes();
    const bool joinColumns = fine.columns > 1 && (fine.rows == 1 || sideways > weakCoupling * upward);
    const bool joinRows = fine.rows > 1 && (fine.columns == 1 || upward > weakCoupling * sideways);
    levels_.emplace_back(fine.across.coarser(joinColumns), fine.up.coarser(joinRows));
  }
  // Interpolation takes from where cells are coupled, which does not change.
  Member alone;
  prepare(alone, layout.solved);
  for (Level& l : levels_)
    for (int row = 0; row < l.rows && &l != &levels_.front(); ++row)
      for (int column = 0; column < l.columns; ++column) {
        const int c = l.at(column, row);
        if (l.west[c] > 0.0f) l.toWest[c] = l.across.back[column];
        if (l.west[c + 1] > 0.0f) l.toEast[c] = l.across.forth[column + 1];
        if (l.south[c] > 0.0f) l.toSouth[c] = l.up.back[row];
        if (l.south[c + l.stride] > 0.0f) l.toNorth[c] = l.up.forth[row + 1];
      }
}

void Multigrid::prepare(Member& member, const std::vector<double>& coefficient) {
  Level& finest = levels_.front();
  const std::size_t frame = coefficient.size() / 2;
  // The outlet's coefficients stand in the row above the last.
  const Range rows = member.share(finest.rows + 1);
  for (int c = finest.at(0, static_cast<int>(rows.begin)); c < finest.at(0, static_cast<int>(rows.end));
       ++c) {
    finest.west[c] = static_cast<float>(coefficient[c]);
    finest.south[c] = static_cast<float>(coefficient[frame + c]);
  }
  member.wait();
  prepareBelow(member, 0);
}

void Multigrid::prepareBelow(Member& member, std::size_t l) {
  Level& fine = levels_[l];
  if (fine.columns * fine.rows < worthSharing && member.shares()) {
    Member alone;
    if (member.first()) prepareBelow(alone, l);
    return member.wait();
  }
  fine.updateDiagonal(fine.places(member));
  if (l + 1 == levels_.size()) return;
  coarsen(fine, levels_[l + 1], member.share(levels_[l + 1].rows + 1));
  member.wait();
  prepareBelow(member, l + 1);
}

void Multigrid::coarsen(const Level& fine, Level& coarse, Range rows) const {
  const int columnStep = coarse.across.joined ? 2 : 1, rowStep = coarse.up.joined ? 2 : 1;
  for (int row = static_cast<int>(rows.begin); row < static_cast<int>(rows.end); ++row)
    for (int column = 0; column < coarse.columns; ++column) {
      const int to = coarse.at(column, row), fineColumn = columnStep * column;
      const int fineRow = std::min(rowStep * row, fine.rows);
      // Beyond the last column or row stands nothing, or the row of the outlet, which has no upright faces.
      const int from = fine.at(fineColumn, fineRow);
      const float beside = columnStep == 2 ? fine.south[from + 1] : 0.0f;
      const float above = rowStep == 2 && row < coarse.rows ? fine.west[from + fine.stride] : 0.0f;
      coarse.west[to] = static_cast<float>(coarse.across.conduction[column]) * (fine.west[from] + above);
      coarse.south[to] = static_cast<float>(coarse.up.conduction[row]) * (fine.south[from] + beside);
    }
}

void Multigrid::restrict(const Level& fine, const std::vector<float>& residual, Level& coarse,
                         Range rows) const {
  for (int row = static_cast<int>(rows.begin); row < static_cast<int>(rows.end); ++row) {
    // The fine rows of this coarse one and those beside them. What is not there are rows of zeros.
    const float* zero = &residual[fine.at(0, fine.rows + 1)];
    const float *lower = zero, *upper = zero, *below = zero, *above = zero;
    if (coarse.up.joined) {
      lower = &residual[fine.at(0, 2 * row)];
      upper = lower + fine.stride;
      below = lower - fine.stride;
      above = upper + fine.stride;
    } else {
      lower = &residual[fine.at(0, row)];
    }
    const int first = coarse.at(0, row), n = coarse.stride;
    const float *toWest = &coarse.toWest[first], *toEast = &coarse.toEast[first];
    const float *toSouth = &coarse.toSouth[first], *toNorth = &coarse.toNorth[first];
    float* b = &coarse.b[first];
    if (!coarse.across.joined) {
      for (int i = 0; i < coarse.columns; ++i)
        b[i] = lower[i] + upper[i] + (toNorth[i - n] * below[i] - toSouth[i] * lower[i]) +
               (toSouth[i + n] * above[i] - toNorth[i] * upper[i]);
      continue;
    }
    for (int i = 0; i < coarse.columns; ++i) {
      const int f = 2 * i;
      const float left = lower[f] + upper[f], right = lower[f + 1] + upper[f + 1];
      const float west = lower[f - 1] + upper[f - 1], east = lower[f + 2] + upper[f + 2];
      b[i] = left + right + (toEast[i - 1] * west - toWest[i] * left) +
             (toWest[i + 1] * east - toEast[i] * right) +
             (toNorth[i - n] * (below[f] + below[f + 1]) - toSouth[i] * (lower[f] + lower[f + 1])) +
             (toSouth[i + n] * (above[f] + above[f + 1]) - toNorth[i] * (upper[f] + upper[f + 1]));
    }
  }
}

void Multigrid::prolong(const Level& coarse, Level& fine, Range rows) const {
  const int perRow = coarse.up.joined ? 2 : 1;
  for (int row = static_cast<int>(rows.begin); row < static_cast<int>(rows.end); ++row)
    for (int half = 0; half < perRow && perRow * row + half < fine.rows; ++half) {
      const int first = coarse.at(0, row);
      const float* own = &coarse.x[first];
      const float* beside = half == 0 ? own - coarse.stride : own + coarse.stride;
      const float* share = half == 0 ? &coarse.toSouth[first] : &coarse.toNorth[first];
      const float *toWest = &coarse.toWest[first], *toEast = &coarse.toEast[first];
      float* x = &fine.x[fine.at(0, perRow * row + half)];
      if (!coarse.across.joined) {
        for (int i = 0; i < coarse.columns; ++i) x[i] += own[i] + share[i] * (beside[i] - own[i]);
        continue;
      }
      const auto first_ = [&](int i) {
        return own[i] + share[i] * (beside[i] - own[i]) + toWest[i] * (own[i - 1] - own[i]);
      };
      for (int i = 0; i < fine.columns / 2; ++i) {
        x[2 * i] += first_(i);
        x[2 * i + 1] += own[i] + share[i] * (beside[i] - own[i]) + toEast[i] * (own[i + 1] - own[i]);
      }
      if (fine.columns % 2 == 1) x[fine.columns - 1] += first_(fine.columns / 2);
    }
}

void Multigrid::cycle(Member& member, std::size_t l) {
  Level& fine = levels_[l];
  if (fine.columns * fine.rows < worthSharing && member.shares()) {
    Member alone;
    if (member.first()) cycle(alone, l);
    return member.wait();
  }
  const Range mine = fine.places(member);
  if (l + 1 == levels_.size()) {
    for (std::size_t c = mine.begin; c < mine.end; ++c) fine.x[c] = fine.perDiagonal[c] * fine.b[c];
    return member.wait();
  }
  for (std::size_t c = mine.begin; c < mine.end; ++c)
    fine.other[c] = firstDamping * fine.perDiagonal[c] * fine.b[c];
  member.wait();
  fine.smooth(fine.other, fine.x, secondDamping, mine);
  member.wait();
  fine.residual(fine.x, fine.other, mine);
  member.wait();
  Level& coarse = levels_[l + 1];
  restrict(fine, fine.other, coarse, member.share(coarse.rows));
  member.wait();
  cycle(member, l + 1);
  prolong(coarse, fine, member.share(coarse.rows));
  member.wait();
  fine.smooth(fine.x, fine.other, secondDamping, mine);
  member.wait();
  fine.smooth(fine.other, fine.x, firstDamping, mine);
  member.wait();
}

}  // namespace bedmix
