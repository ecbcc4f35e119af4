// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bedmix {

/// A column of a run's series, and what a legend calls it.
struct PlotColumn {
  std::string_view name;
  std::string_view label;
};

/// One kind of figure: which columns of which file of the run folder it draws over time.
struct PlotKind {
  std::string_view name;
  std::string_view file;  // e.g. "mixing.csv"
  std::span<const PlotColumn> columns;
  std::string_view yLabel;
  double yMin = 0.0, yMax = 0.0;  // shown at least; more where the data go beyond
};
/// mixing (Fig. 6), compare, flux (Figs 7 and 10), pressure; the first is the default.
std::span<const PlotKind> plotKinds();
Result<const PlotKind*> findPlotKind(std::string_view name);

/// y over time x, s, of one length; NaN in y leaves a gap. With a band, `low` and `high` are of
/// that length, too.
struct Curve {
  std::string label;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> low = {}, high = {};

  bool hasBand() const { return !low.empty(); }
};

/// Whether there is anything to draw.
bool hasValues(std::span<const Curve> curves);

/// A height the curves are to be seen against.
struct Level {
  double y = 0.0;
  std::string label;
};

/// Draws curves with gnuplot into a .png, .svg or .pdf file for a column of a journal, 88 mm wide (.png at
/// 600 dpi), and leaves what it draws beside it: `path`.csv, a column a curve and "nan" where it has a gap,
/// and `path`.gp, the script. Fails as `unavailable` without gnuplot. The same curves give the same bytes.
Result<Done> writePlot(const std::filesystem::path& path, const PlotKind& kind, std::span<const Curve> curves,
                       std::span<const Level> levels = {});

}  // namespace bedmix
