// SPDX-License-Identifier: MIT
#include "engine/coupling/coupling_grid.h"

#include <algorithm>

namespace bedmix {

namespace {

/// Depth below an open top over which the coupling fades, in diameters: long enough that a rising plug leaves
/// the gas grid without a jump in voidage, short against the freeboard.
constexpr double taperDiameters = 5.0;

}  // namespace

CouplingGrid::CouplingGrid(const Scene& scene, const GasGrid& grid)
    : x(scene.gas->grid.columns, scene.bed.width),
      y(scene.gas->grid.rows, scene.bed.height),
      stride(grid.columns + 2),
      rows(grid.rows + 2),
      perDiameter(1.0 / scene.particles.diameter),
      particleVolume(bedmix::particleVolume(scene)) {
  if (scene.bed.top == BedTop::open) {  // against a lid the gas holds particles at the very top
    taperSlope = perDiameter / taperDiameters;
    taperShift = grid.y.back() * taperSlope;
  }
  const auto lowest = [&](int column) { return grid.lowestRow[std::clamp(column, 0, grid.columns - 1)]; };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < stride; ++column) {
      const int cell = std::clamp(column - 1, 0, grid.columns - 1), face = std::min(column, grid.columns);
      const int lowestOfFace = std::min(lowest(face - 1), lowest(face));
      cells.push_back({cell, std::clamp(row - 1, lowest(cell), grid.rows - 1)});
      uprightFaces.push_back({face, std::clamp(row - 1, lowestOfFace, grid.rows - 1)});
      levelFaces.push_back({cell, std::clamp(row, lowest(cell), grid.rows)});
    }
}

Range CouplingGrid::columnsOf(const ThreadTeam& team, int member) const {
  const auto all = static_cast<std::size_t>(x.cells);
  Range part = team.share(all, member);
  if (part.begin == part.end) return part;
  // The ghosts at either end go with their owners.
  if (part.begin > 0) ++part.begin;
  part.end += part.end == all ? 2 : 1;
  return part;
}

}  // namespace bedmix
