// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/period.h"
#include "replay/analysis/analysis.h"

#include <vector>

namespace bedmix {

/// Solids flux through lines across the bed, each way by itself, kg/(m2 s): the mass of the particles whose
/// centres are on the other side one frame later, over time and area. What goes to and fro within a frame's
/// interval is not seen; the net flux is exact: of a line across the whole bed it is the change of the mass
/// above it.
///
/// Tables "flux_horizontal", through lines at heights of whole diameters above the floor below each point:
/// height, m; up, down and net, upward; and "flux_vertical", through the upright centre line, by stretches of
/// a diameter: height of its middle, m; left, right and net, leftward as in flux.csv.
class Crossings final : public Analysis {
 public:
  explicit Crossings(const AnalysisInput& input);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override;
  std::vector<FoundNumber> findings() const override;

 private:
  /// Particles that crossed, upward or leftward and against that.
  struct Count {
    double with = 0.0, against = 0.0;
  };
  std::size_t lineBelow(double height) const;

  const Scene& scene_;
  Period period_;
  double spacing_;  // m
  Frame previous_;  // ids and places only
  bool started_ = false;
  double duration_ = 0.0;                // s
  double frames_ = 0.0, heights_ = 0.0;  // of the bed, summed, m
  std::vector<Count> lines_;             // horizontal, from the floor on
  std::vector<Count> stretches_;         // of the centre line
};

}  // namespace bedmix
