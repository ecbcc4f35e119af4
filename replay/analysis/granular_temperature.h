// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/mixing.h"
#include "replay/analysis/analysis.h"

namespace bedmix {

/// How fast particles move against each other: <|v - mean of the cell|^2>/2, m2/s2, over the particles of the
/// sampling cells that hold at least `sampling.min_particles`; two directions of motion, hence the half (a
/// third in space; Gidaspow 1994, ch. 9). A gradient within a cell counts: T = (shear + diffusive)/2 of
/// `mechanisms` where velocities last from frame to frame. Table "temperature": time, temperature, its parts
/// along x and y.
class GranularTemperature final : public Analysis {
 public:
  explicit GranularTemperature(const AnalysisInput& input);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override { return {{"temperature", table_}}; }
  std::vector<FoundNumber> findings() const override;

 private:
  SamplingGrid grid_;
  Table table_;
};

}  // namespace bedmix
