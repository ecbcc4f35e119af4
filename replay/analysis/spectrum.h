// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"
#include "replay/analysis/analysis.h"

#include <optional>
#include <vector>

namespace bedmix {

/// Power spectral density of pressure drop and bed height about their means: mean periodogram of segments
/// with a Hann window that overlap by half (Welch 1967), one-sided, so that its integral is the variance.
/// Segments hold the largest power of two of frames that is at most a third of all, which must be equally
/// spaced. The dominant frequency is where the density is largest.
///
/// Table "spectrum": frequency, Hz; pressure_drop, Pa2/Hz (empty without gas); bed_height, m2/Hz.
class Spectrum final : public Analysis {
 public:
  explicit Spectrum(const AnalysisInput& input);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override { return {{"spectrum", table()}}; }
  std::vector<FoundNumber> findings() const override;

 private:
  Table table() const;

  const Scene& scene_;
  double interval_;  // s
  std::optional<GasGrid> grid_;
  std::vector<double> pressure_, height_;  // Pa, m
};

}  // namespace bedmix
