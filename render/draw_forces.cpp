// SPDX-License-Identifier: MIT
#include "render/draw_forces.h"

#include "engine/core/particle_list.h"
#include "engine/core/period.h"
#include "engine/core/walls.h"
#include "render/scales.h"
#include "render/shapes.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

/// Particles in square cells of a diameter, so that what touches is in the same or a neighbouring cell. Those
/// beyond the grid are in its outermost cells.
struct Cells {
  int columns = 1, rows = 1;
  double size = 0.0;                 // m
  std::vector<std::uint32_t> first;  // per cell, and the end
  std::vector<std::uint32_t> order;  // particles by cell, in a cell by row of the frame

  int index(double at, int count) const {
    return static_cast<int>(std::clamp(at / size, 0.0, static_cast<double>(count - 1)));
  }
  std::size_t cell(Vec2f p) const {
    return static_cast<std::size_t>(index(static_cast<double>(p.y), rows)) *
               static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(index(static_cast<double>(p.x), columns));
  }
};

Cells sortIntoCells(const Frame& frame, const Scene& scene) {
  constexpr double most = 2048.0;  // cells along a side
  const BedSettings& bed = scene.bed;
  Cells cells;
  cells.size = std::max({particleRange(scene).largest, bed.width / most, 1.5 * bed.height / most});
  cells.columns = static_cast<int>(std::ceil(bed.width / cells.size));
  cells.rows = static_cast<int>(std::ceil(1.5 * bed.height / cells.size));
  cells.first.assign(static_cast<std::size_t>(cells.columns) * static_cast<std::size_t>(cells.rows) + 1, 0);
  for (const Vec2f& p : frame.position) ++cells.first[cells.cell(p) + 1];
  for (std::size_t c = 1; c < cells.first.size(); ++c) cells.first[c] += cells.first[c - 1];
  std::vector<std::uint32_t> next(cells.first.begin(), cells.first.end() - 1);
  cells.order.resize(frame.size());
  for (std::size_t i = 0; i < frame.size(); ++i)
    cells.order[next[cells.cell(frame.position[i])]++] = static_cast<std::uint32_t>(i);
  return cells;
}

}  // namespace

std::vector<FrameContact> contactsOf(const Frame& frame, const Scene& scene) {
  const auto radius = [&](std::uint32_t i) { return radiusOf(scene, frame, i); };
  const Cells cells = sortIntoCells(frame, scene);
  std::vector<WallSegment> walls = allWalls(scene);
  for (WallSegment& wall : walls) wall = wallAt(wall, frame.time);
  std::vector<FrameContact> contacts;
  const auto addPair = [&](std::uint32_t i, std::uint32_t j) {
    const Vec2f a = frame.position[i], b = frame.position[j];
    const double overlap = radius(i) + radius(j) - norm(toDouble(b) - toDouble(a));
    if (overlap <= 0.0) return;
    const double effective = radius(i) * radius(j) / (radius(i) + radius(j));
    contacts.push_back({a, b, elasticForce(scene, overlap, effective)});
  };
  const Period period(scene);
  const auto addAcross = [&](std::uint32_t i, std::uint32_t j) {
    const Vec2 a = toDouble(frame.position[i]), b = toDouble(frame.position[j]),
               apart = period.nearest(b - a);
    const double overlap = radius(i) + radius(j) - norm(apart);
    if (apart == b - a || overlap <= 0.0) return;
    const double force = elasticForce(scene, overlap, radius(i) * radius(j) / (radius(i) + radius(j)));
    contacts.push_back({frame.position[i], toFloat(a + apart), force});  // at either side
    contacts.push_back({toFloat(b - apart), frame.position[j], force});
  };
  const auto forCell = [&](int row, int column, std::uint32_t from, const auto& visit) {
    if (row < 0 || row >= cells.rows || column < 0 || column >= cells.columns) return;
    const std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.columns) +
                             static_cast<std::size_t>(column);
    for (std::uint32_t k = std::max(from, cells.first[cell]); k < cells.first[cell + 1]; ++k)
      visit(cells.order[k]);
  };
  const auto addPairs = [&](std::uint32_t i, std::uint32_t from, int row, int column) {
    forCell(row, column, from, [&](std::uint32_t j) { addPair(i, j); });
  };
  for (std::uint32_t k = 0; k < cells.order.size(); ++k) {
    const std::uint32_t i = cells.order[k];
    const Vec2f at = frame.position[i];
    const int row = cells.index(static_cast<double>(at.y), cells.rows);
    const int column = cells.index(static_cast<double>(at.x), cells.columns);
    addPairs(i, k + 1, row, column);  // each pair once: what comes later here, then to the right and above
    addPairs(i, 0, row, column + 1);
    for (int side = -1; side <= 1; ++side) addPairs(i, 0, row + 1, column + side);
    if (period.isOn() && column == 0)  // the last column may be narrower than a diameter
      for (int other = row - 1; other <= row + 1; ++other)
        for (int last = cells.columns - 2; last < cells.columns; ++last)
          forCell(other, last, 0, [&](std::uint32_t j) { addAcross(i, j); });
    for (const WallSegment& wall : walls) {
      const Vec2 touched = nearestOn(wall, toDouble(at));
      const double overlap = radius(i) - norm(touched - toDouble(at));
      if (overlap > 0.0) contacts.push_back({at, toFloat(touched), elasticForce(scene, overlap, radius(i))});
    }
  }
  return contacts;
}

float forceWidth(const Scene& scene, const Camera& camera, double force) {
  return camera.length(scene.particles.diameter * std::min(1.0, force / forceScale(scene)));
}

void drawForces(DrawList& list, const BedView& view) {
  const std::size_t first = list.lines.size();
  for (const FrameContact& contact : contactsOf(view.frame, view.scene)) {
    const float width = forceWidth(view.scene, view.camera, contact.force);
    const Vec2f from = view.camera.toPixel(contact.from), to = view.camera.toPixel(contact.to);
    if (width < 0.25f || (isOutside(list.clip, from, width) && isOutside(list.clip, to, width))) continue;
    list.lines.push_back({from, to, width, 0.0f, forceColor});
  }
  addRims(list, first, 0.06f * view.em, view.palette.wall);
}

}  // namespace bedmix
