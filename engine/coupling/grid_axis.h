// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

#include <vector>

namespace bedmix {

/// One axis of the gas grid: stretches of equal cells, so few that trying each costs less than a table.
struct GridAxis {
  GridAxis(const std::vector<GridSpan>& spans, double axisLength);

  struct Stretch {
    double start;          // its lowest face, m
    double size, perSize;  // of a cell, m, 1/m
    double firstCell;      // a whole number
    double lastCell;       // counted from the first
    /// From the centre below the stretch's lowest face to that above it weights change at another rate, since
    /// the cells differ: where this begins and ends, m, and the size of the cell below and above over the
    /// distance.
    double fromCentre = 0.0, toCentre = 0.0, slopeBelow = 1.0, slopeAbove = 1.0;
  };
  std::vector<Stretch> stretches;
  int cells = 0;
  double length = 0.0;  // m
};

inline GridAxis::GridAxis(const std::vector<GridSpan>& spans, double axisLength) : length(axisLength) {
  double start = 0.0;
  for (const GridSpan& span : spans) {
    Stretch s{start, span.size, 1.0 / span.size, static_cast<double>(cells),
              static_cast<double>(span.count - 1)};
    if (!stretches.empty()) {
      const double below = stretches.back().size, distance = 0.5 * (below + s.size);
      s.fromCentre = start - 0.5 * below;
      s.toCentre = start + 0.5 * s.size;
      s.slopeBelow = below / distance;
      s.slopeAbove = s.size / distance;
    }
    stretches.push_back(s);
    start += static_cast<double>(span.count) * span.size;
    cells += static_cast<int>(span.count);
  }
}

}  // namespace bedmix
