// SPDX-License-Identifier: MIT
#pragma once

#include "render/plot.h"

namespace bedmix {

/// Quantiles the band of an ensemble lies between.
inline constexpr double bandLow = 0.1, bandHigh = 0.9;

/// The median of several curves and a band from their 10 % to their 90 % quantile (linear between the values:
/// with few curves nearly their whole range), each time by itself. Times are those that all curves still
/// going have in common; a curve that has a gap there does not count, and where all have, the result has one.
Curve medianAndBand(std::span<const Curve> runs, std::string label);

}  // namespace bedmix
