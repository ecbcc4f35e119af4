// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "replay/csv.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bedmix {

/// What an analysis knows of the frames to come.
struct AnalysisInput {
  const Scene& scene;      // outlives the analysis
  std::size_t frames = 0;  // how many there will be, at least one
  double interval = 0.0;   // s, between them on average; 0 where there is but one
};

/// A number that an analysis found; empty where it is not defined for the run.
struct FoundNumber {
  std::string name;  // e.g. "dispersion_x"
  std::optional<double> value;
  std::string unit;  // "" where it has none
};

/// A table that an analysis made, written as NAME.csv.
struct NamedTable {
  std::string name;
  Table table;
};

/// Something derived from the frames of a run, fed to it in order; what it keeps does not grow with the
/// particles times the frames.
class Analysis : public FrameSink {
 public:
  /// To be asked after the last frame.
  virtual std::vector<NamedTable> tables() const = 0;
  virtual std::vector<FoundNumber> findings() const = 0;
};

/// One selectable analysis: its name, what it derives and by which definition, where that comes from.
struct AnalysisKind {
  std::string_view name;
  std::string_view what;
  std::string_view citation;
  /// Why the scene does not have what it needs; empty where it does.
  std::string_view (*lacks)(const Scene& scene);
  std::unique_ptr<Analysis> (*make)(const AnalysisInput& input);
};

/// The table of all.
std::span<const AnalysisKind> analysisKinds();

/// Those of a comma-separated list of names, or with "all" every one that the scene has what it needs for.
/// Fails on unknown names, with the table of the known ones, and on those that lack something.
Result<std::vector<const AnalysisKind*>> chooseAnalyses(std::string_view names, const Scene& scene);

}  // namespace bedmix
