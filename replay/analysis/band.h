// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/sampling_grid.h"
#include "replay/analysis/analysis.h"

namespace bedmix {

/// Lacey's and Ashton's indices over time with what the choice of cells leaves open, table "band": time, and
/// each with the ends of its interval by mixingBand(), drawn by the frame's step so that a frame has the same
/// band in whatever selection.
class Band final : public Analysis {
 public:
  explicit Band(const AnalysisInput& input);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override { return {{"band", table_}}; }
  /// Mean widths of the intervals over the second half of the frames.
  std::vector<FoundNumber> findings() const override;

 private:
  SamplingGrid grid_;
  Table table_;
};

}  // namespace bedmix
