// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/mixing.h"
#include "engine/core/period.h"
#include "engine/core/start_correlation.h"

#include <optional>
#include <span>
#include <string_view>

namespace bedmix {

/// What the indices of one frame are computed from.
struct MixingState {
  const Frame& frame;
  const CellStatistics& cells;
  const StartCorrelation& start;
  Period period = {};
};

/// One index of mixing: what tables call it, how it is computed, where it comes from and what it needs.
struct MixingIndex {
  std::string_view name;
  std::string_view formula;
  std::string_view citation;
  std::string_view needs;
  /// Empty where it is not defined.
  std::optional<double> (*of)(const MixingState& state);
};

/// The one table of all. In the formulas C and n are tracer fraction and particles of a used cell; the bar,
/// S^2, sigma_0^2, sigma_r^2, K, N, p and h as in CellStatistics. assets/docs/indices.md says which to trust.
std::span<const MixingIndex> mixingIndices();

/// Lacey's index with each cell counting as often as it has particles. S_w^2 = sum n (C - p)^2/N lies between
/// sigma_0^2 = p (1-p), where each cell holds but one species, and its mean over all ways to tag so many of
/// the particles, which is p (1-p) (K-1)/(N-1) whatever the cells hold (hypergeometric variance of C: p
/// (1-p)/n (N-n)/(N-1)). So the index is exactly 0 where segregated, and exactly 1 on average where random,
/// in cells however unlike.
std::optional<double> weightedLaceyIndex(const CellStatistics& cells);

/// Asmar, Langston & Matchett (2002), Granular Matter 4:129: mean coordinate of the tracer over that of all
/// particles, along x and along y, from the lower left corner of the bed. 1 where the centres agree.
struct MeanPositionIndex {
  std::optional<double> x, y;
};
MeanPositionIndex meanPositionIndex(const Frame& frame);

}  // namespace bedmix
