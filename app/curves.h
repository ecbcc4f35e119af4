// SPDX-License-Identifier: MIT
#pragma once

#include "render/plot.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace bedmix {

/// Whether the folder has the series that a kind of plot draws.
bool hasSeries(const std::filesystem::path& folder, const PlotKind& kind);

/// What plots of one or several runs' folders draw, each curve called by its column, by its run (runNames()),
/// or by both, as far as it takes to tell them apart.
Result<std::vector<Curve>> curvesOf(std::span<const std::string> runs, const PlotKind& kind);

/// The same with runs of one scene that differ in nothing but the seed as one curve, their median, and a band
/// (render/band.h), called by the scene. Fails where a folder has no trajectory to tell its scene.
Result<std::vector<Curve>> ensembleCurves(std::span<const std::string> runs, const PlotKind& kind);

/// What the kind's curves are seen against: A = 0.9, from which on a bed counts as mixed; or the weight of
/// the bed over its area, where all runs tell the same.
std::vector<Level> levelsOf(std::span<const std::string> runs, const PlotKind& kind);

}  // namespace bedmix
