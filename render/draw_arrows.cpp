// SPDX-License-Identifier: MIT
#include "render/draw_arrows.h"

#include "engine/core/gas_grid.h"
#include "engine/core/mixing.h"
#include "render/scales.h"
#include "render/shapes.h"

#include <algorithm>

namespace bedmix {

namespace {

constexpr std::int32_t fewest = 5;  // particles that make a mean

/// In the picture y points down.
Vec2f shiftOf(Vec2f velocity, float pxPerSpeed) {
  return {pxPerSpeed * velocity.x, -pxPerSpeed * velocity.y};
}

/// With its middle at `at`, m.
void addCentred(DrawList& list, const BedView& view, Vec2 at, Vec2f shift, float width, Rgba color) {
  addArrow(list, view.camera.toPixel(at) - shift * 0.5f, shift, width, color);
}

}  // namespace

void drawVelocity(DrawList& list, const BedView& view) {
  const Frame& frame = view.frame;
  const float pxPerSpeed = view.camera.length(arrowScale(view.scene, Layer::velocity));
  const float width = std::max(1.0f, view.camera.length(0.2 * view.scene.particles.diameter));
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Vec2f at = view.camera.toPixel(frame.position[i]);
    if (isOutside(list.clip, at, 0.0f)) continue;
    addArrow(list, at, shiftOf(frame.velocity[i], pxPerSpeed), width, velocityColor);
  }
}

void drawFlow(DrawList& list, const BedView& view) {
  const SamplingGrid grid = samplingGrid(view.scene);
  const std::vector<Vec2> mean = meanVelocities(view.frame, grid, fewest);
  const double dx = grid.width / grid.columns, dy = grid.height / grid.rows;
  const float pxPerSpeed = view.camera.length(arrowScale(view.scene, Layer::flow));
  const float width = std::clamp(view.camera.length(0.08 * std::min(dx, dy)), 1.5f, 0.3f * view.em);
  const std::size_t first = list.lines.size();
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Vec2 velocity = mean[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                                 static_cast<std::size_t>(column)];
      addCentred(list, view, {(column + 0.5) * dx, (row + 0.5) * dy}, shiftOf(toFloat(velocity), pxPerSpeed),
                 width, flowColor);
    }
  addRims(list, first, 0.1f * view.em, view.palette.ground);
}

void drawGas(DrawList& list, const BedView& view) {
  const GasGrid grid = makeGasGrid(view.scene);
  const float pxPerSpeed = view.camera.length(arrowScale(view.scene, Layer::gas));
  const float width = std::max(1.0f, view.camera.length(0.1 * grid.dx(0)));
  const std::size_t first = list.lines.size();
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!grid.open(column, row)) continue;
      const Vec2 centre{grid.x[column] + 0.5 * grid.dx(column), grid.y[row] + 0.5 * grid.dy(row)};
      const Vec2f velocity = view.frame.gas.velocity[grid.cell(column, row)];
      addCentred(list, view, centre, shiftOf(velocity, pxPerSpeed), width, view.palette.gas);
    }
  addRims(list, first, width, view.palette.ground);
}

}  // namespace bedmix
