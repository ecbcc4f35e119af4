// SPDX-License-Identifier: MIT
#include "render/plot.h"

#include "render/band.h"
#include "render/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace bedmix {

namespace {

constexpr PrintSize column{88.0, 55.0, 600.0};
constexpr double legendLine = 5.0;       // mm
constexpr std::size_t legendWidth = 52;  // characters, of which
constexpr std::size_t signWidth = 8;     // before a label

constexpr std::array mixingColumns{PlotColumn{"lacey", "Lacey"}, PlotColumn{"ashton", "Ashton"}};
constexpr std::array compareColumns{PlotColumn{"ashton", "Ashton"}};
constexpr std::array fluxColumns{PlotColumn{"flux", "solids flux"}};
constexpr std::array pressureColumns{PlotColumn{"pressure_drop", "pressure drop"}};
constexpr std::array heatColumns{PlotColumn{"particle_temperature", "particles"},
                                 PlotColumn{"outlet_temperature", "gas at the outlet"}};
constexpr std::array reactionColumns{PlotColumn{"content", "content"}};
constexpr std::array feedColumns{PlotColumn{"particles", "in the bed"}, PlotColumn{"left", "left so far"}};
constexpr std::array residenceColumns{PlotColumn{"share", "left after"},
                                      PlotColumn{"stirred", "stirred tank"}};

const std::array kinds{
    PlotKind{"mixing", "mixing.csv", mixingColumns, "mixing index", -0.1, 1.3},
    PlotKind{"compare", "mixing.csv", compareColumns, "Ashton index", -0.1, 1.3},
    PlotKind{"flux", "flux.csv", fluxColumns, "solids flux leftward, kg/(m\u00b2 s)"},
    PlotKind{"pressure", "pressure.csv", pressureColumns, "pressure drop, Pa"},
    PlotKind{"heat", "heat.csv", heatColumns, "temperature, K"},
    PlotKind{"reaction", "reaction.csv", reactionColumns, "content, kg/kg"},
    PlotKind{"feed", "feed.csv", feedColumns, "particles"},
    PlotKind{"residence", "residence_times.csv", residenceColumns, "share of the particles", 0.0, 1.0},
};

/// As a field of a table, quoted where it has to be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Adds the curve's columns at row `k`: a number, "nan" for a gap. Nothing at all where the curve has no
/// sample, which gnuplot passes over.
void addFields(std::string& text, const Curve& c, std::optional<std::size_t> k) {
  const auto add = [&](const std::vector<double>& values) {
    text += ',';
    if (!k) return;
    if (std::isfinite(values[*k]))
      fmt::format_to(std::back_inserter(text), "{}", values[*k]);
    else
      text += "nan";
  };
  add(c.y);
  if (c.hasBand()) {
    add(c.low);
    add(c.high);
  }
}

/// One row a time at which any of the curves has a sample.
std::string tableOf(std::span<const Curve> curves) {
  std::string text = "time";
  std::vector<double> times;
  for (const Curve& c : curves) {
    text += ',' + field(c.label);
    if (c.hasBand()) text += ',' + field(c.label + " low") + ',' + field(c.label + " high");
    times.insert(times.end(), c.x.begin(), c.x.end());
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<std::size_t> next(curves.size());
  for (const double time : times) {
    fmt::format_to(std::back_inserter(text), "\n{}", time);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const bool sampled = next[i] < curves[i].x.size() && curves[i].x[next[i]] == time;
      addFields(text, curves[i], sampled ? std::optional(next[i]++) : std::nullopt);
    }
  }
  return text + '\n';
}

bool hasBands(std::span<const Curve> curves) {
  return std::any_of(curves.begin(), curves.end(), [](const Curve& c) { return c.hasBand(); });
}

/// Whether all the labels fit in one row above the curves.
bool isShortLegend(std::span<const Curve> curves, std::span<const Level> levels) {
  std::size_t width = 0;
  for (const Curve& c : curves) width += c.label.size() + signWidth;
  for (const Level& l : levels) width += l.label.size() + signWidth;
  return width <= legendWidth && !hasBands(curves);
}

/// A label that fits into the figure: of a long one beginning and end.
std::string fitting(std::string label) {
  constexpr std::size_t most = legendWidth - signWidth, end = most / 2;
  if (label.size() <= most) return label;
  const auto within = [&](std::size_t at) { return (static_cast<unsigned char>(label[at]) & 0xC0) == 0x80; };
  std::size_t from = end - 3, to = label.size() - end;
  while (within(from)) --from;  // UTF-8
  while (to < label.size() && within(to)) ++to;
  return label.substr(0, from) + "..." + label.substr(to);
}

std::string keyFor(std::span<const Curve> curves, std::span<const Level> levels) {
  if (curves.size() + levels.size() == 1 && !hasBands(curves)) return "unset key\n";
  if (isShortLegend(curves, levels)) return "set key tmargin center horizontal Left reverse samplen 2\n";
  std::string key = "set key tmargin left vertical Left reverse samplen 2 maxcols 1";
  if (hasBands(curves))
    key += fmt::format(" title 'median of the runs, band from {:g} to {:g} %' left", 100.0 * bandLow,
                       100.0 * bandHigh);
  return key + '\n';
}

/// The kind's range where that holds the curves, else one that ends at tics beyond them.
std::string yRange(const PlotKind& kind, std::span<const Curve> curves) {
  const auto fits = [&](const std::vector<double>& values) {
    return std::none_of(values.begin(), values.end(),
                        [&](double y) { return y < kind.yMin || y > kind.yMax; });
  };
  const bool all = kind.yMin < kind.yMax && std::all_of(curves.begin(), curves.end(), [&](const Curve& c) {
                     return fits(c.y) && fits(c.low) && fits(c.high);
                   });
  return all ? fmt::format("[{} : {}]", kind.yMin, kind.yMax)
             : fmt::format("[* < {} : {} < *]", kind.yMin, kind.yMax);
}

std::string commandsFor(const PlotKind& kind, std::span<const Curve> curves, std::span<const Level> levels) {
  std::string text = "set datafile separator comma\n";
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "set xlabel 't, s'\nset ylabel {}\nset xrange [0:*]\nset yrange {}\n",
                 plotText(kind.yLabel), yRange(kind, curves));
  text += plotFrame;
  text += "set xzeroaxis linewidth 1 linetype 1 linecolor rgb '#A0A0A0'\n";
  text += keyFor(curves, levels);

  std::string bands, lines;
  std::size_t at = 2;  // column of the table
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string color = plotColor(i);
    if (curves[i].hasBand())
      bands += fmt::format(
          "  data skip 1 using 1:{}:{} with filledcurves fillcolor rgb '{}' fillstyle transparent solid 0.25 "
          "noborder notitle, \\\n",
          at + 1, at + 2, color);
    lines += fmt::format(
        "  data skip 1 using 1:{} with lines linewidth 1 dashtype {} linecolor rgb '{}' title {}, \\\n", at,
        plotDashes(i), color, plotText(fitting(curves[i].label)));
    at += curves[i].hasBand() ? 3 : 1;
  }
  for (const Level& level : levels)
    lines += fmt::format("  {} with lines linewidth 1.2 dashtype 2 linecolor rgb '#606060' title {}, \\\n",
                         level.y, plotText(fitting(level.label)));
  return text + "plot \\\n" + bands + lines.substr(0, lines.rfind(','));
}

/// A tall legend does not press the curves.
PrintSize sizeFor(std::span<const Curve> curves, std::span<const Level> levels) {
  PrintSize size = column;
  if (!isShortLegend(curves, levels))
    size.height += legendLine * static_cast<double>(curves.size() + levels.size() + hasBands(curves));
  return size;
}

}  // namespace

std::span<const PlotKind> plotKinds() { return kinds; }

Result<const PlotKind*> findPlotKind(std::string_view name) {
  std::string known;
  for (const PlotKind& kind : kinds) {
    if (kind.name == name) return &kind;
    known += known.empty() ? "" : ", ";
    known += kind.name;
  }
  return Diagnostic{{}, fmt::format("there is no kind of plot '{}'; the kinds are {}", name, known)};
}

bool hasValues(std::span<const Curve> curves) {
  return std::any_of(curves.begin(), curves.end(), [](const Curve& c) {
    return std::any_of(c.y.begin(), c.y.end(), [](double y) { return std::isfinite(y); });
  });
}

Result<Done> writePlot(const std::filesystem::path& path, const PlotKind& kind, std::span<const Curve> curves,
                       std::span<const Level> levels) {
  if (!hasValues(curves))
    return Diagnostic{{path.string()}, "there is no value to plot; is the run shorter than a sample?"};
  return drawTable(path, commandsFor(kind, curves, levels), tableOf(curves), sizeFor(curves, levels));
}

}  // namespace bedmix
