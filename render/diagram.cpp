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

using SeriesStyle = DiagramSeries::Style;

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
  const auto look =
      fmt::format("linecolor rgb '{}' pointtype {} pointsize 1.5", plotColor(number), 4 + number % 10);
  switch (series.style) {
    case SeriesStyle::front:
      return "using 1:2 with fsteps linewidth 1 dashtype 3 linecolor rgb '#A0A0A0'";
    case SeriesStyle::marked:
      return fmt::format(
          "using 1:2 with points pointtype {} pointsize 3 linewidth 1.5 linecolor rgb '#D55E00'",
          6 + 2 * (number % 4));
    case SeriesStyle::background:
      return fmt::format("{} linewidth 0.7 linecolor rgb '#B0B0B0' pointtype 7 pointsize 0.8", points);
    case SeriesStyle::points:
      return fmt::format("{} linewidth 1.3 {}", points, look);
    case SeriesStyle::line:
      break;
  }
  return fmt::format("using 1:2 with linespoints linewidth 1 dashtype {} {}", plotDashes(number), look);
}

/// Labels for an axis that shows less than two decades: 1, 2 and 5 times powers of ten.
std::string shortLogTics(char axis, double from, double to) {
  std::string tics;
  for (double decade = std::pow(10.0, std::floor(std::log10(from))); decade <= to; decade *= 10.0)
    for (const double tic : {decade, 2.0 * decade, 5.0 * decade})
      if (tic >= from && tic <= to) tics += fmt::format("{}{:.6g}", tics.empty() ? "" : ", ", tic);
  return fmt::format("set {}tics ({})\n", axis, tics);
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
  const double from = low / margin, to = high * margin;
  return fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\nset format {0} '%g'\n", axis, from, to) +
         (to < 100.0 * from ? shortLogTics(axis, from, to) : "");
}

void addPanel(std::string& text, const DiagramPanel& panel, std::size_t index) {
  std::string blocks, plot;
  std::size_t lines = 0, marks = 0, entries = 0;  // those without points keep their colours and rings
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    const DiagramSeries& series = panel.series[s];
    const std::string name = fmt::format("$p{}s{}", index, s);
    std::size_t number = 0;
    if (series.style == SeriesStyle::marked)
      number = marks++;
    else if (series.style != SeriesStyle::background)
      number = lines++;
    if (!addBlock(blocks, name, series, panel)) continue;
    ++entries;
    plot += fmt::format("{} {} {} {}", plot.empty() ? "plot" : ",", name, drawing(series, number),
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
  if (panel.logY) text += logAxis('y', panel);
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
  return drawWithGnuplot(path, text + "unset multiplot", {127.0 * columns, 76.2 * rows});
}

}  // namespace bedmix
