// SPDX-License-Identifier: MIT
#include "render/diagram.h"

#include "render/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace bedmix {

namespace {

using Style = DiagramSeries::Style;

bool isDrawn(const DiagramPoint& p, const DiagramPanel& panel) {
  return std::isfinite(p.x) && std::isfinite(p.y) && (p.x > 0.0 || !panel.logX) && (p.y > 0.0 || !panel.logY);
}

/// Its data as gnuplot's inline block; false where nothing of it is drawn.
bool addBlock(std::string& text, const std::string& name, const DiagramSeries& series,
              const DiagramPanel& panel) {
  std::string rows;
  for (const DiagramPoint& p : series.points)
    if (isDrawn(p, panel)) rows += fmt::format("{} {} {} {}\n", p.x, p.y, p.low, p.high);
  if (!rows.empty()) text += fmt::format("{} << END\n{}END\n", name, rows);
  return !rows.empty();
}

/// How it is drawn; `number` counts series of its kind.
std::string drawing(const DiagramSeries& series, std::size_t number) {
  const bool hasBars = std::any_of(series.points.begin(), series.points.end(),
                                   [](const DiagramPoint& p) { return p.low != p.y || p.high != p.y; });
  const char* const points = hasBars ? "using 1:2:3:4 with yerrorbars" : "using 1:2 with points";
  const auto look = fmt::format("linecolor rgb '{}' pointtype {} pointsize 1.5",
                                plotColors[number % plotColors.size()], 4 + number % 10);
  switch (series.style) {
    case Style::front:
      return "using 1:2 with fsteps linewidth 1 dashtype 3 linecolor rgb '#A0A0A0'";
    case Style::marked:
      return fmt::format(
          "using 1:2 with points pointtype {} pointsize 3 linewidth 1.5 linecolor rgb '#D55E00'",
          6 + 2 * (number % 4));
    case Style::background:
      return fmt::format("{} linewidth 0.7 linecolor rgb '#B0B0B0' pointtype 7 pointsize 0.8", points);
    case Style::points:
      return fmt::format("{} linewidth 1.3 {}", points, look);
    case Style::line:
      break;
  }
  return fmt::format("using 1:2 with linespoints linewidth 1 dashtype {} {}", number / plotColors.size() + 1,
                     look);
}

/// A logarithmic axis that shows a decade at least.
std::string logAxis(char axis, const DiagramPanel& panel) {
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  for (const DiagramSeries& series : panel.series)
    for (const DiagramPoint& p : series.points)
      if (isDrawn(p, panel)) {
        const double value = axis == 'x' ? p.x : p.y;
        low = std::min(low, value);
        high = std::max(high, value);
      }
  const double margin = std::max(1.5, std::sqrt(12.0 * low / high));
  return fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\n", axis, low / margin, high * margin);
}

void addPanel(std::string& text, const DiagramPanel& panel, std::size_t index) {
  std::string blocks, plot;
  std::size_t lines = 0, marks = 0, entries = 0;
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    const DiagramSeries& series = panel.series[s];
    const std::string name = fmt::format("$p{}s{}", index, s);
    const bool isMark = series.style == Style::marked;
    if (!addBlock(blocks, name, series, panel)) continue;
    ++entries;
    plot += fmt::format("{} {} {} {}", plot.empty() ? "plot" : ",", name,
                        drawing(series, isMark ? marks++ : lines++),
                        series.label.empty() ? "notitle" : "title " + plotText(series.label));
  }
  if (plot.empty()) {
    text += "set multiplot next\n";
    return;
  }
  text += blocks + "reset\n" + std::string(plotFrame);
  fmt::format_to(std::back_inserter(text), "set title {}\nset xlabel {}\nset ylabel {}\n",
                 plotText(panel.title), plotText(panel.xLabel), plotText(panel.yLabel));
  if (panel.logX) text += logAxis('x', panel);
  if (panel.logY) text += logAxis('y', panel) + "set format y '%.0e'\n";
  if (!panel.logY)
    text += "set offsets 0, 0, graph 0.05, graph 0.05\nset xzeroaxis linewidth 1 linecolor rgb '#808080'\n";
  const std::size_t rows = (entries + 1) / 2;
  fmt::format_to(std::back_inserter(text),
                 "set key below Left reverse samplen 2 maxcols 2\nset bmargin {}\n{}\n", rows + 4, plot);
}

}  // namespace

Result<Done> writeDiagram(const std::filesystem::path& path, std::span<const DiagramPanel> panels) {
  const int columns = panels.size() > 1 ? 2 : 1;
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  std::string text = fmt::format("set multiplot layout {},{}\n", rows, columns);
  for (std::size_t p = 0; p < panels.size(); ++p) addPanel(text, panels[p], p);
  return drawWithGnuplot(path, text + "unset multiplot", columns, rows);
}

}  // namespace bedmix
