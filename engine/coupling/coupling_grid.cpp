// SPDX-License-Identifier: MIT
#include "engine/coupling/coupling_grid.h"

#include <algorithm>

namespace bedmix {

namespace {

/// Depth below an open top over which the coupling fades, in diameters: long enough that a rising plug leaves
/// the gas grid without a jump in voidage, short against the freeboard.
constexpr double taperDiameters = 5.0;

}  // namespace

CouplingGrid::CouplingGrid(const Scene& scene, const GasGrid& gasGrid)
    : x(scene.gas->grid.columns, scene.bed.width),
      y(scene.gas->grid.rows, scene.bed.height),
      stride(x.cells + 2),
      rows(y.cells + 2),
      perDiameter(1.0 / scene.particles.diameter),
      particleVolume(bedmix::particleVolume(scene)),
      gas_(gasGrid) {
  if (scene.bed.top == BedTop::open) {  // against a lid the gas holds particles at the very top
    taperSlope = perDiameter / taperDiameters;
    taperShift = y.length * taperSlope;
  }
  for (std::int32_t row = 0; row < rows; ++row)
    for (std::int32_t column = 0; column < stride; ++column)
      cellOwner_.push_back(static_cast<std::int32_t>(point(cellOf({column, row}))));
}

std::int32_t CouplingGrid::columnOf(Place point) const {
  if (gas_.repeats) return gas_.columnAround(point.i - 1);
  return std::clamp(point.i - 1, 0, x.cells - 1);
}

CouplingGrid::Place CouplingGrid::cellOf(Place point) const {
  const std::int32_t i = columnOf(point);
  const auto cell = static_cast<std::int32_t>(gas_.openCellFor(i, std::clamp(point.j - 1, 0, y.cells - 1)));
  return {cell % x.cells, cell / x.cells};
}

CouplingGrid::Place CouplingGrid::uprightFaceOf(Place point) const {
  std::int32_t i = std::min(point.i, x.cells), left = std::max(i - 1, 0), right = std::min(i, x.cells - 1);
  if (gas_.repeats) {
    i = right = point.i % x.cells;
    left = gas_.columnAround(i - 1);
  }
  const std::int32_t j =
      std::clamp(point.j - 1, std::min(gas_.lowestRow[left], gas_.lowestRow[right]), y.cells - 1);
  if (gas_.open(left, j) || gas_.open(right, j)) return {i, j};
  // Within an obstacle: the near side of the open cell.
  const Place cell = cellOf({point.i, j + 1});
  return {std::clamp(i, cell.i, cell.i + 1), cell.j};
}

CouplingGrid::Place CouplingGrid::levelFaceOf(Place point) const {
  const std::int32_t i = columnOf(point);
  const std::int32_t j = std::clamp(point.j, gas_.lowestRow[i], y.cells);
  if (gas_.open(i, std::max(j - 1, 0)) || gas_.open(i, std::min(j, y.cells - 1))) return {i, j};
  const Place cell = cellOf({point.i, j + 1});
  return {cell.i, std::clamp(j, cell.j, cell.j + 1)};
}

Range CouplingGrid::columnsOf(const ThreadTeam& team, int member) const {
  // Around obstacles, and of ghosts where sides are periodic, owners may be in other columns.
  if (!gas_.openCell.empty() || gas_.repeats) return {0, member == 0 ? static_cast<std::size_t>(stride) : 0};
  const auto all = static_cast<std::size_t>(x.cells);
  Range part = team.share(all, member);
  if (part.begin == part.end) return part;
  // The ghosts at either end go with their owners.
  if (part.begin > 0) ++part.begin;
  part.end += part.end == all ? 2 : 1;
  return part;
}

}  // namespace bedmix
