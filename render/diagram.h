// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace bedmix {

/// A point of a diagram; a bar from `low` to `high` where these differ from y.
struct DiagramPoint {
  double x = 0.0, y = 0.0;
  double low = 0.0, high = 0.0;
};

/// Points of one name. Those that are not finite, or not positive on a logarithmic axis, are left out.
struct DiagramSeries {
  enum class Style {
    line,        // points joined in their order
    points,      // with bars where they have some
    background,  // the same in grey
    front,       // a thin line of steps in the background, without points
    marked,      // large rings around points of other series
  };
  std::string label;  // none: not in the legend
  Style style = Style::line;
  std::vector<DiagramPoint> points;
};

struct DiagramPanel {
  std::string title, xLabel, yLabel;
  bool logX = true, logY = true;
  std::vector<DiagramSeries> series;
};

/// Draws panels, two in a row, with gnuplot into a .png, .svg or .pdf file, which gets its name when it is
/// complete. A panel without a point is left empty. Fails as `unavailable` without gnuplot.
Result<Done> writeDiagram(const std::filesystem::path& path, std::span<const DiagramPanel> panels);

}  // namespace bedmix
