// SPDX-License-Identifier: MIT
#include "render/draw_sampling.h"

#include "engine/core/mixing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr float smallestText = 7.0f;  // px
// Of the text's height: DejaVu Sans' digits, and the longest text in a cell, "1.00" or four digits.
constexpr float digitWidth = 0.55f;
constexpr float longestText = 4.0f * digitWidth;

float cellWidth(const SamplingGrid& grid, const Camera& camera) {
  return camera.length(grid.width / grid.columns);
}
float cellHeight(const SamplingGrid& grid, const Camera& camera) {
  return camera.length(grid.height / grid.rows);
}

/// Height of two lines of text that fit a cell, px.
float textSize(const SamplingGrid& grid, const Camera& camera, float em) {
  return std::floor(
      std::min({0.85f * cellWidth(grid, camera) / longestText, 0.45f * cellHeight(grid, camera), em}));
}

Box cellBox(const SamplingGrid& grid, const Camera& camera, int column, int row) {
  const Vec2f low = camera.toPixel(Vec2{grid.width * column / grid.columns, grid.height * row / grid.rows});
  const Vec2f high =
      camera.toPixel(Vec2{grid.width * (column + 1) / grid.columns, grid.height * (row + 1) / grid.rows});
  return {low.x, high.y, high.x, low.y};
}

/// Calls `use(box, cell)` for each cell.
template <class Use>
void forCells(const SamplingGrid& grid, const Camera& camera, const Use& use) {
  std::size_t cell = 0;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) use(cellBox(grid, camera, column, row), cell++);
}

}  // namespace

void addHatching(DrawList& list, const Box& box, float em, Rgba color) {
  const float spacing = 0.5f * em, width = std::max(1.0f, 0.05f * em);
  // Lines x + y = c, in the picture's own raster so that they go on from cell to cell.
  for (float c = spacing * std::ceil((box.left + box.top) / spacing); c < box.right + box.bottom;
       c += spacing) {
    const float left = std::max(box.left, c - box.bottom), right = std::min(box.right, c - box.top);
    list.lines.push_back({{left, c - left}, {right, c - right}, width, 0.0f, color});
  }
}

void drawSampling(DrawList& list, const BedView& view) {
  const SamplingGrid grid = samplingGrid(view.scene);
  const Camera& camera = view.camera;
  const float width = std::max(1.0f, 0.08f * view.em);
  for (int c = 0; c <= grid.columns; ++c) {
    const double x = grid.width * c / grid.columns;
    list.lines.push_back({camera.toPixel(Vec2{x, 0.0}), camera.toPixel(Vec2{x, grid.height}), width, 0.0f,
                          view.palette.sampling});
  }
  for (int r = 0; r <= grid.rows; ++r) {
    const double y = grid.height * r / grid.rows;
    list.lines.push_back({camera.toPixel(Vec2{0.0, y}), camera.toPixel(Vec2{grid.width, y}), width, 0.0f,
                          view.palette.sampling});
  }
  if (std::min(cellWidth(grid, camera), cellHeight(grid, camera)) < view.em) return;
  const CellCounts counts = countCells(view.frame, grid);
  forCells(grid, camera, [&](const Box& box, std::size_t cell) {
    if (counts.all[cell] < grid.minParticles) addHatching(list, box, view.em, view.palette.sampling);
  });
}

void drawCounts(DrawList& list, const BedView& view) {
  const SamplingGrid grid = samplingGrid(view.scene);
  const float size = textSize(grid, view.camera, view.em);
  if (size < smallestText) return;
  const CellCounts counts = countCells(view.frame, grid);
  Rgba plate = view.palette.ground;
  plate.a = 225;
  forCells(grid, view.camera, [&](const Box& box, std::size_t cell) {
    if (counts.all[cell] < grid.minParticles) return;
    const Vec2f middle{0.5f * (box.left + box.right), 0.5f * (box.top + box.bottom)};
    const double fraction = static_cast<double>(counts.tracer[cell]) / counts.all[cell];
    // Plates behind the rows, as texts are drawn over discs: strokes as tall as a row.
    const auto plates = [&](std::size_t characters, float down) {
      const float half = 0.5f * (digitWidth * static_cast<float>(characters) - 0.7f) * size;
      const Vec2f row = middle + Vec2f{0.0f, down * size};
      list.lines.push_back({row - Vec2f{half, 0.0f}, row + Vec2f{half, 0.0f}, 1.05f * size, 0.0f, plate});
    };
    plates(std::to_string(counts.all[cell]).size(), -0.5f);
    plates(4, 0.5f);
    list.texts.push_back({middle, {0.5f, 1.0f}, view.palette.ink, std::to_string(counts.all[cell]), size});
    list.texts.push_back({middle, {0.5f, 0.0f}, view.palette.ink, fmt::format("{:.2f}", fraction), size});
  });
}

std::vector<Diagnostic> countsProblems(const Scene& scene, const Camera& camera, float em) {
  const SamplingGrid grid = samplingGrid(scene);
  const float size = textSize(grid, camera, std::max(em, smallestText));
  if (size >= smallestText) return {};
  const float times = std::max(longestText * smallestText / (0.85f * cellWidth(grid, camera)),
                               smallestText / (0.45f * cellHeight(grid, camera)));
  return {{{},
           fmt::format("the layer 'counts' has no room in sampling cells of {:.0f} x {:.0f} pixels; take a "
                       "picture {:.1f} times as large, or fewer cells",
                       cellWidth(grid, camera), cellHeight(grid, camera), std::ceil(10.0f * times) / 10.0f)}};
}

}  // namespace bedmix
