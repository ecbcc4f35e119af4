// SPDX-License-Identifier: MIT
#include "render/draw_fields.h"

#include "engine/core/gas_grid.h"
#include "render/scales.h"
#include "render/shapes.h"

namespace bedmix {

Rgba fieldColor(Layer field, double t) { return field == Layer::gasTemperature ? warmth(t) : cividis(t); }

void drawField(DrawList& list, const BedView& view, Layer field) {
  const GasGrid grid = makeGasGrid(view.scene);
  const GasFrame& gas = view.frame.gas;
  const ColorRange range = colorRange(view.scene, field);
  const auto value = [&](std::size_t cell) {
    if (field == Layer::gasSpeed) return norm(gas.velocity[cell]);
    if (field == Layer::gasTemperature) return gas.temperature[cell];
    return field == Layer::voidage ? gas.voidage[cell] : gas.pressure[cell];
  };
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (!grid.open(column, row)) continue;
      addRectangle(list, view.camera.toPixel(Vec2{grid.x[column], grid.y[row + 1]}),
                   view.camera.toPixel(Vec2{grid.x[column + 1], grid.y[row]}),
                   fieldColor(field, range.share(static_cast<double>(value(grid.cell(column, row))))));
    }
}

}  // namespace bedmix
