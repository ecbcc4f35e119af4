// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/period.h"
#include "replay/analysis/analysis.h"

#include <string>

namespace bedmix {

/// A straight line in the bed; its left is on the left of who goes from `from` to `to`.
struct FluxLine {
  Vec2 from{}, to{};  // m
};

/// Solids flux through a line, each way by itself, kg/(m2 s): mass of the particles whose centre's straight
/// way from one frame to the next crosses it, over the time between them, the line's length and the bed's
/// thickness. Net through a line across the bed it is, exactly, the change of the mass behind it.
///
/// Table `name`: time, at the end of the interval, flux to the left less that to the right, and both.
/// Findings are their means, e.g. "line_1_flux".
class LineFlux final : public Analysis {
 public:
  LineFlux(const AnalysisInput& input, FluxLine line, std::string name);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override { return {{name_, table_}}; }
  std::vector<FoundNumber> findings() const override;

 private:
  FluxLine line_;
  Period period_;
  std::string name_;
  double massOverArea_;  // kg/m2, of a particle
  Frame previous_;       // time, ids and places only
  Table table_;
};

}  // namespace bedmix
