// SPDX-License-Identifier: MIT
#include "engine/effects/heat_gas.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bedmix {

GasHeat::GasHeat(const Scene& scene, const GasSolver& gas, const std::vector<double>& voidage)
    : gas_(gas), voidage_(voidage) {
  const HeatSettings& heat = *scene.effects.find<HeatSettings>();
  capacity_ = scene.gas->density * heat.gas->heatCapacity;
  conductivity_ = heat.gas->conductivity;
  inletTemperature_ = heat.inletTemperature();
  wallTemperature_ = heat.wallTemperature;
  const FaceLayout& layout = gas.layout();
  const GasGrid& grid = gas.grid();
  const auto around = [&grid](int i) { return grid.repeats ? grid.columnAround(i) : i; };
  const auto at = [&](int column, int j) {
    const int i = around(column);
    return i >= 0 && i < grid.columns && j >= 0 && j < grid.rows && grid.open(i, j)
               ? static_cast<int>(grid.cell(i, j))
               : -1;
  };
  for (const int index : layout.openCells) {
    const int i = index % grid.columns, j = index / grid.columns;
    const auto& [left, right, bottom, top] = layout.cellFaces[index];
    Cell& cell = cells_.emplace_back();
    cell.index = index;
    cell.volume = layout.cellVolume[index];
    const double upright = grid.dy(j) * grid.thickness, level = grid.dx(i) * grid.thickness;
    const auto side = [](int face, int beyond, double outward, double area, double half, double otherHalf) {
      return Side{face, beyond, outward, area / (beyond < 0 ? half : half + otherHalf)};
    };
    const auto halfWidth = [&](int column) {
      const int c = around(column);
      return c >= 0 && c < grid.columns ? 0.5 * grid.dx(c) : 0.0;
    };
    const auto halfHeight = [&](int r) { return r >= 0 && r < grid.rows ? 0.5 * grid.dy(r) : 0.0; };
    cell.sides = {side(left, at(i - 1, j), -1.0, upright, halfWidth(i), halfWidth(i - 1)),
                  side(right, at(i + 1, j), 1.0, upright, halfWidth(i), halfWidth(i + 1)),
                  side(bottom, at(i, j - 1), -1.0, level, halfHeight(j), halfHeight(j - 1)),
                  side(top, at(i, j + 1), 1.0, level, halfHeight(j), halfHeight(j + 1))};
    cell.sides[2].isFloor = j == grid.lowestRow[i];
    cell.sides[3].isOutlet = j == grid.rows - 1;
  }
  temperature_.assign(grid.cells(), heat.gas->temperature);
  coefficient_.assign(grid.cells(), 0.0);
  source_.assign(grid.cells(), 0.0);
  change_.assign(grid.cells() + 1, 0.0);
  rows_.resize(cells_.size());
}

GasHeat::Row GasHeat::row(const Cell& cell, double passed) const {
  const FaceLayout& layout = gas_.layout();
  const double here = temperature_[cell.index];
  double diagonal = capacity_ * voidage_[cell.index] * cell.volume / passed + coefficient_[cell.index];
  Row row{};
  row.right = source_[cell.index] - coefficient_[cell.index] * here;
  row.beyond.fill(static_cast<int>(change_.size()) - 1);
  for (std::size_t k = 0; k < cell.sides.size(); ++k) {
    const Side& side = cell.sides[k];
    const double flow =
        gas_.fields().velocity[side.face] * gas_.faceVoidage()[side.face] * layout.faceArea[side.face];
    const double convected = capacity_ * std::max(0.0, -side.outward * flow);
    const double conducted = conductivity_ * side.perDistance *
                             (1.0 - std::sqrt(1.0 - std::min(1.0, gas_.faceVoidage()[side.face])));
    if (side.beyond >= 0) {
      row.beyond[k] = side.beyond;
      row.share[k] = convected + conducted;
      diagonal += row.share[k];
      row.right += row.share[k] * (temperature_[side.beyond] - here);
    } else if (side.isFloor && flow > 0.0) {
      diagonal += convected;
      row.right += convected * (inletTemperature_ - here);
    } else if (!side.isOutlet && wallTemperature_) {
      diagonal += conducted;
      row.right += conducted * (*wallTemperature_ - here);
    }
  }
  row.perDiagonal = 1.0 / diagonal;
  return row;
}

double GasHeat::relax(std::size_t k) {
  const Row& row = rows_[k];
  double sum = row.right;
  for (std::size_t s = 0; s < row.beyond.size(); ++s) sum += row.share[s] * change_[row.beyond[s]];
  const double was = std::exchange(change_[cells_[k].index], sum * row.perDiagonal);
  return std::abs(change_[cells_[k].index] - was);
}

// Sweeps upward, the way most of the gas goes, and back again.
void GasHeat::solve() {
  constexpr int mostSweeps = 1000;
  constexpr double ofTemperature = 1e-14;
  const double small = ofTemperature * *std::max_element(temperature_.begin(), temperature_.end());
  std::fill(change_.begin(), change_.end(), 0.0);
  for (int sweep = 0; sweep < mostSweeps; ++sweep) {
    double moved = 0.0;
    if (sweep % 2 == 0)
      for (std::size_t k = 0; k < cells_.size(); ++k) moved = std::max(moved, relax(k));
    else
      for (std::size_t k = cells_.size(); k-- > 0;) moved = std::max(moved, relax(k));
    if (moved <= small) return;
  }
}

void GasHeat::advance(double passed) {
  for (std::size_t k = 0; k < cells_.size(); ++k) rows_[k] = row(cells_[k], passed);
  solve();
  for (const Cell& cell : cells_) temperature_[cell.index] += change_[cell.index];
  voidage_ = gas_.fields().voidage;
}

void GasHeat::save(StateWriter& out) const {
  out.putAll(temperature_);
  out.putAll(voidage_);
}

bool GasHeat::load(StateReader& in) { return in.getAll(temperature_) && in.getAll(voidage_); }

}  // namespace bedmix
