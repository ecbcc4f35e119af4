// SPDX-License-Identifier: MIT
#include "render/plot.h"

#include "render/gnuplot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace bedmix {

namespace {

constexpr std::array mixingColumns{PlotColumn{"lacey", "Lacey"}, PlotColumn{"ashton", "Ashton"}};
constexpr std::array compareColumns{PlotColumn{"ashton", "Ashton"}};
constexpr std::array fluxColumns{PlotColumn{"flux", "solids flux"}};
constexpr std::array pressureColumns{PlotColumn{"pressure_drop", "pressure drop"}};

const std::array kinds{
    PlotKind{"mixing", "mixing.csv", mixingColumns, "mixing index", 0.0, 1.4},
    PlotKind{"compare", "mixing.csv", compareColumns, "Ashton index", 0.0, 1.4},
    PlotKind{"flux", "flux.csv", fluxColumns, "solids flux leftward, kg/(m\u00b2 s)"},
    PlotKind{"pressure", "pressure.csv", pressureColumns, "pressure drop, Pa"},
};

std::string commandsFor(const PlotKind& kind, std::span<const Curve> curves) {
  std::string text;
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    fmt::format_to(out, "$curve{} << END\n", i);
    const Curve& c = curves[i];
    for (std::size_t k = 0; k < std::min(c.x.size(), c.y.size()); ++k) {
      if (std::isfinite(c.y[k]))
        fmt::format_to(out, "{} {}\n", c.x[k], c.y[k]);
      else
        text += "\n";  // an empty line interrupts a curve
    }
    text += "END\n";
  }
  fmt::format_to(out, "set xlabel 't, s'\nset ylabel {}\nset xrange [0:*]\nset yrange [* < {} : {} < *]\n",
                 plotText(kind.yLabel), kind.yMin, kind.yMax);
  text += plotFrame;
  text += curves.size() > 1 ? "set key outside top center horizontal Left reverse\n" : "unset key\n";
  for (std::size_t i = 0; i < curves.size(); ++i)
    fmt::format_to(out,
                   "{} $curve{} using 1:2 with lines linewidth 1 dashtype {} linecolor rgb '{}' title {}",
                   i == 0 ? "plot" : ",", i, i / plotColors.size() + 1, plotColors[i % plotColors.size()],
                   plotText(curves[i].label));
  return text;
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

Result<Done> writePlot(const std::filesystem::path& path, const PlotKind& kind,
                       std::span<const Curve> curves) {
  const bool drawable = std::any_of(curves.begin(), curves.end(), [](const Curve& c) {
    return std::any_of(c.y.begin(), c.y.end(), [](double y) { return std::isfinite(y); });
  });
  if (!drawable)
    return Diagnostic{{path.string()}, "there is no value to plot; is the run shorter than a sample?"};

  return drawWithGnuplot(path, commandsFor(kind, curves));
}

}  // namespace bedmix
