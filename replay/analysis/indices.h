// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/mixing_indices.h"
#include "replay/analysis/analysis.h"

#include <optional>

namespace bedmix {

/// Over which an index is averaged before it is asked whether the bed is mixed, s: single samples of some 22
/// cells scatter by 0.1, so that the first of them above a level comes early by chance; a tenth of a second
/// averages ten of the paper's samples and is short against the seconds that mixing takes.
inline constexpr double mixedWindow = 0.1;

/// First of `times` at which the mean over the `window` around it is at least `level`; it counts what is
/// defined, and only where the whole window lies within `times`.
std::optional<double> timeToReach(const Table::Column& times, const Table::Column& values, double level,
                                  double window);

/// Mean of what is defined in the second half of a column.
std::optional<double> secondHalfMean(const Table::Column& column);

/// All of mixingIndices() over time, table "indices", and the angle of the principal component from x.
/// Findings: means over the second half of the frames; when Lacey's and Ashton's reach mixedIndex.
class Indices final : public Analysis {
 public:
  explicit Indices(const AnalysisInput& input);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override { return {{"indices", table_}}; }
  std::vector<FoundNumber> findings() const override;

 private:
  SamplingGrid grid_;
  Period period_;
  std::optional<StartCorrelation> start_;  // from the first frame on
  Table table_;
};

}  // namespace bedmix
