// SPDX-License-Identifier: MIT
#pragma once

#include "render/colors.h"
#include "render/draw_list.h"
#include "render/index_curve.h"

#include <span>
#include <string>
#include <vector>

namespace bedmix {

/// One curve of a chart: an index of a run.
struct ChartCurve {
  std::string label;
  Rgba color;
  const IndexCurve* curve = nullptr;
  float IndexCurve::Point::*index = &IndexCurve::Point::ashton;
};

struct Chart {
  std::string title;
  std::vector<ChartCurve> curves;
};

/// What films show: Lacey's and Ashton's index of one run, Ashton's of each of several.
Chart indexChart(std::span<const std::string> labels, std::span<const IndexCurve> runs);

/// Draws curves over time into `list`, whose clip it sets to the axes, and their axes and texts into
/// `overlay`. The axes end at `until`, s, and fit into `box`, px.
void drawChart(DrawList& list, DrawList& overlay, const Box& box, const Chart& chart, double until, float em,
               const Palette& palette = {});

/// Where the axes of a chart in `box` are, px.
Box chartAxes(const Box& box, std::size_t curves, float em);

}  // namespace bedmix
