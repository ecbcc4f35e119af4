// SPDX-License-Identifier: MIT
#include "engine/core/gas_grid.h"

#include "engine/core/gas_obstacles.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

std::vector<double> faces(const std::vector<GridSpan>& spans, double length) {
  std::vector<double> at{0.0};
  for (const GridSpan& span : spans) {
    const double start = at.back();
    for (std::int64_t i = 1; i <= span.count; ++i) at.push_back(start + static_cast<double>(i) * span.size);
  }
  at.back() = length;  // the reader has checked the sum; this removes its rounding
  return at;
}

}  // namespace

GasGrid makeGasGrid(const Scene& scene) {
  GasGrid grid;
  grid.x = faces(scene.gas->grid.columns, scene.bed.width);
  grid.y = faces(scene.gas->grid.rows, scene.bed.height);
  grid.columns = static_cast<int>(grid.x.size()) - 1;
  grid.rows = static_cast<int>(grid.y.size()) - 1;
  grid.thickness = scene.bed.thickness;
  grid.repeats = scene.bed.sides == BedSides::periodic;
  for (int c = 0; c < grid.columns; ++c) {
    const double left = grid.x[c], right = grid.x[c + 1];
    const double floor = floorHeight(scene, 0.5 * (left + right));
    int row = 0;
    while (row + 1 < grid.rows && std::abs(grid.y[row + 1] - floor) <= std::abs(grid.y[row] - floor)) ++row;
    grid.lowestRow.push_back(row);
    double flow = 0.0;
    for (const Inlet& inlet : scene.gas->inlets) {
      const double covered = std::min(right, inlet.to) - std::max(left, inlet.from);
      if (covered > 0.0) flow += covered * inletVelocity(scene, inlet);
    }
    grid.inletFlux.push_back(flow / (right - left));
  }
  if (!scene.obstacles.empty()) blockCells(scene, grid);
  return grid;
}

}  // namespace bedmix
