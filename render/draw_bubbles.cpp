// SPDX-License-Identifier: MIT
#include "render/draw_bubbles.h"

#include "engine/core/gas_grid.h"
#include "render/shapes.h"

#include <algorithm>
#include <array>

namespace bedmix {

namespace {

/// The first wall, the middles of the stretches between faces, the last wall.
std::vector<double> nodesOf(const std::vector<double>& faces) {
  std::vector<double> nodes{faces.front()};
  for (std::size_t i = 1; i < faces.size(); ++i) nodes.push_back(0.5 * (faces[i - 1] + faces[i]));
  nodes.push_back(faces.back());
  return nodes;
}

struct Corner {
  Vec2 at;        // m
  double excess;  // of the voidage over the level
};

/// Where between two corners on different sides the level is met.
Vec2 crossing(const Corner& a, const Corner& b) {
  return a.at + (b.at - a.at) * (a.excess / (a.excess - b.excess));
}

/// Appends the lines within a square; corners in turn around it.
void addSquare(DrawList& list, const BedView& view, const std::array<Corner, 4>& corners) {
  std::array<Vec2f, 4> met;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Corner &a = corners[i], &b = corners[(i + 1) % 4];
    if ((a.excess > 0.0) != (b.excess > 0.0)) met[count++] = view.camera.toPixel(crossing(a, b));
  }
  const float width = bubbleWidth(view.em);
  const auto add = [&](std::size_t from, std::size_t to) {
    list.lines.push_back({met[from], met[to], width, 0.0f, bubbleColor});
  };
  if (count == 2) add(0, 1);
  if (count < 4) return;
  // A saddle: the middle joins one pair of corners, and the lines cut off the others.
  const double middle = corners[0].excess + corners[1].excess + corners[2].excess + corners[3].excess;
  const bool joinsFirst = (middle > 0.0) == (corners[0].excess > 0.0);
  add(0, joinsFirst ? 1 : 3);
  add(joinsFirst ? 2 : 1, joinsFirst ? 3 : 2);
}

}  // namespace

float bubbleWidth(float em) { return std::max(1.5f, 0.15f * em); }

void drawBubbles(DrawList& list, const BedView& view) {
  const GasGrid grid = makeGasGrid(view.scene);
  const std::vector<double> x = nodesOf(grid.x), y = nodesOf(grid.y);
  // The cell whose value a node has.
  const auto cellOf = [](int node, int cells) { return std::clamp(node - 1, 0, cells - 1); };
  const std::size_t first = list.lines.size();
  for (int row = 0; row + 1 < static_cast<int>(y.size()); ++row)
    for (int column = 0; column + 1 < static_cast<int>(x.size()); ++column) {
      std::array<Corner, 4> corners;
      bool open = true;
      for (std::size_t i = 0; i < 4; ++i) {
        const int nodeX = column + (i == 1 || i == 2), nodeY = row + (i >= 2);
        const int cellX = cellOf(nodeX, grid.columns), cellY = cellOf(nodeY, grid.rows);
        open = open && grid.open(cellX, cellY);
        const double voidage = static_cast<double>(view.frame.gas.voidage[grid.cell(cellX, cellY)]);
        corners[i] = {{x[static_cast<std::size_t>(nodeX)], y[static_cast<std::size_t>(nodeY)]},
                      voidage - view.style.bubbleVoidage};
      }
      if (open) addSquare(list, view, corners);
    }
  addRims(list, first, 0.06f * view.em, view.palette.ground);
}

}  // namespace bedmix
