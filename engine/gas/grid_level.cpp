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
  // As in FaceLayout.
  const auto size = static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows + 3);
  for (auto* field : {&west, &south, &perDiagonal, &b, &smoothed, &x, &toWest, &toEast, &toSouth, &toNorth})
    field->assign(size, 0.0f);
}

GridLevel GridLevel::coarser() const {
  const double sideways = across.sumOfCouplings() * up.sumOfSizes();
  const double upward = up.sumOfCouplings() * across.sumOfSizes();
  const bool joinColumns = columns > 1 && (rows == 1 || sideways > weakCoupling * upward);
  const bool joinRows = rows > 1 && (columns == 1 || upward > weakCoupling * sideways);
  return {across.coarser(joinColumns), up.coarser(joinRows)};
}

void GridLevel::updateDiagonal(Range mine) {
  for (int c = at(0, static_cast<int>(mine.begin)); c < at(0, static_cast<int>(mine.end)); ++c) {
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

}  // namespace bedmix
