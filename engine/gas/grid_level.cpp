// SPDX-License-Identifier: MIT
#include "engine/gas/grid_level.h"

#include <algorithm>
#include <utility>

namespace bedmix {

namespace {

constexpr double weakCoupling = 0.2;  // of the other direction's: joining along it would not help

}  // namespace

double LevelAxis::sumOfSizes() const {
  double sum = 0.0;
  for (double s : size) sum += s;
  return sum;
}

double LevelAxis::sumOfCouplings() const {
  double sum = 0.0;
  for (std::size_t i = 1; i < size.size(); ++i) sum += 2.0 / (size[i - 1] + size[i]);
  return sum;
}

LevelAxis LevelAxis::coarser(bool join) const {
  LevelAxis coarse;
  coarse.joined = join;
  const std::size_t n = join ? (size.size() + 1) / 2 : size.size();
  const auto fineSize = [&](std::size_t i) { return i < size.size() ? size[i] : 0.0; };
  for (std::size_t i = 0; i < n; ++i)
    coarse.size.push_back(join ? fineSize(2 * i) + fineSize(2 * i + 1) : size[i]);
  coarse.conductance.assign(n + 1, 1.0);
  coarse.back.assign(n + 1, 0.0f);
  coarse.forth.assign(n + 1, 0.0f);
  if (!join) return coarse;
  for (std::size_t i = 1; i <= n; ++i) {
    // Cells beside the face; beyond the last there is the outlet, at the face itself.
    const double before = coarse.size[i - 1], behind = i < n ? coarse.size[i] : 0.0;
    const std::size_t last = std::min(2 * i, size.size()) - 1;  // fine cell before the face
    const double fineBefore = size[last], fineBehind = fineSize(2 * i);
    const double distance = 0.5 * (before + behind);
    coarse.conductance[i] = 0.5 * (fineBefore + fineBehind) / distance;
    coarse.forth[i] = static_cast<float>(0.5 * (before - fineBefore) / distance);
    coarse.back[i] = static_cast<float>(0.5 * (behind - fineBehind) / distance);
  }
  return coarse;
}

GridLevel::GridLevel(LevelAxis a, LevelAxis u)
    : across(std::move(a)), up(std::move(u)), columns(across.cells()), rows(up.cells()), stride(columns + 1) {
  // As in FaceLayout; one more, since restrictFrom() looks two places ahead.
  const auto size = static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows + 3) + 1;
  for (auto* field : {&west, &south, &perDiagonal, &x, &other, &b, &toWest, &toEast, &toSouth, &toNorth})
    field->assign(size, 0.0f);
}

GridLevel GridLevel::coarser() const {
  const double sideways = across.sumOfCouplings() * up.sumOfSizes();
  const double upward = up.sumOfCouplings() * across.sumOfSizes();
  const bool joinColumns = columns > 1 && (rows == 1 || sideways > weakCoupling * upward);
  const bool joinRows = rows > 1 && (columns == 1 || upward > weakCoupling * sideways);
  return {across.coarser(joinColumns), up.coarser(joinRows)};
}

Range GridLevel::places(Range mine) const {
  return {static_cast<std::size_t>(at(0, static_cast<int>(mine.begin))),
          static_cast<std::size_t>(at(0, static_cast<int>(mine.end)))};
}

void GridLevel::updateDiagonal(Range mine) {
  const Range all = places(mine);
  for (std::size_t c = all.begin; c < all.end; ++c) {
    const float diagonal = west[c] + west[c + 1] + south[c] + south[c + stride];
    perDiagonal[c] = diagonal > 0.0f ? 1.0f / diagonal : 0.0f;
  }
}

void GridLevel::conductLike(const GridLevel& fine, Range mine) {
  const int columnStep = across.joined ? 2 : 1, rowStep = up.joined ? 2 : 1;
  for (int row = static_cast<int>(mine.begin); row < static_cast<int>(mine.end); ++row)
    for (int column = 0; column < columns; ++column) {
      const int to = at(column, row), fineColumn = columnStep * column;
      const int fineRow = std::min(rowStep * row, fine.rows);
      // Beyond the last column or row stands nothing, or the row of the outlet, which has no upright faces.
      const int from = fine.at(fineColumn, fineRow);
      const float beside = columnStep == 2 ? fine.south[from + 1] : 0.0f;
      const float above = rowStep == 2 && row < rows ? fine.west[from + fine.stride] : 0.0f;
      west[to] = static_cast<float>(across.conductance[column]) * (fine.west[from] + above);
      south[to] = static_cast<float>(up.conductance[row]) * (fine.south[from] + beside);
    }
}

void GridLevel::updateShares() {
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int c = at(column, row);
      if (west[c] > 0.0f) toWest[c] = across.back[column];
      if (west[c + 1] > 0.0f) toEast[c] = across.forth[column + 1];
      if (south[c] > 0.0f) toSouth[c] = up.back[row];
      if (south[c + stride] > 0.0f) toNorth[c] = up.forth[row + 1];
    }
}

void GridLevel::restrictFrom(const GridLevel& fine, Range mine) {
  for (int row = static_cast<int>(mine.begin); row < static_cast<int>(mine.end); ++row) {
    // The fine rows of this coarse one and those beside them. What is not there are rows of zeros.
    const float* zero = &fine.other[fine.at(0, fine.rows + 1)];
    const float *lower = zero, *upper = zero, *below = zero, *above = zero;
    if (up.joined) {
      lower = &fine.other[fine.at(0, 2 * row)];
      upper = lower + fine.stride;
      below = lower - fine.stride;
      above = upper + fine.stride;
    } else {
      lower = &fine.other[fine.at(0, row)];
    }
    const int first = at(0, row), n = stride;
    const float *w = &toWest[first], *e = &toEast[first], *s = &toSouth[first], *t = &toNorth[first];
    float* to = &b[first];
    if (!across.joined) {
      for (int i = 0; i < columns; ++i)
        to[i] = lower[i] + upper[i] + (t[i - n] * below[i] - s[i] * lower[i]) +
                (s[i + n] * above[i] - t[i] * upper[i]);
      continue;
    }
    for (int i = 0; i < columns; ++i) {
      const int f = 2 * i;
      const float left = lower[f] + upper[f], right = lower[f + 1] + upper[f + 1];
      to[i] = left + right + (e[i - 1] * (lower[f - 1] + upper[f - 1]) - w[i] * left) +
              (w[i + 1] * (lower[f + 2] + upper[f + 2]) - e[i] * right) +
              (t[i - n] * (below[f] + below[f + 1]) - s[i] * (lower[f] + lower[f + 1])) +
              (s[i + n] * (above[f] + above[f + 1]) - t[i] * (upper[f] + upper[f + 1]));
    }
  }
}

void GridLevel::prolongTo(GridLevel& fine, Range mine) const {
  const int perRow = up.joined ? 2 : 1;
  for (int row = static_cast<int>(mine.begin); row < static_cast<int>(mine.end); ++row)
    for (int half = 0; half < perRow && perRow * row + half < fine.rows; ++half) {
      const int first = at(0, row);
      const float* own = &x[first];
      const float* beside = half == 0 ? own - stride : own + stride;
      const float* share = half == 0 ? &toSouth[first] : &toNorth[first];
      const float *w = &toWest[first], *e = &toEast[first];
      float* to = &fine.x[fine.at(0, perRow * row + half)];
      if (!across.joined) {
        for (int i = 0; i < columns; ++i) to[i] += own[i] + share[i] * (beside[i] - own[i]);
        continue;
      }
      const auto left = [&](int i) {
        return own[i] + share[i] * (beside[i] - own[i]) + w[i] * (own[i - 1] - own[i]);
      };
      for (int i = 0; i < fine.columns / 2; ++i) {
        to[2 * i] += left(i);
        to[2 * i + 1] += own[i] + share[i] * (beside[i] - own[i]) + e[i] * (own[i + 1] - own[i]);
      }
      if (fine.columns % 2 == 1) to[fine.columns - 1] += left(fine.columns / 2);
    }
}

}  // namespace bedmix
