// SPDX-License-Identifier: MIT
#pragma once

#include "replay/analysis/analysis.h"
#include "replay/analysis/paths.h"

#include <cstdint>
#include <vector>

namespace bedmix {

/// Dispersion coefficients of the particles, D = slope/2 of their mean-square displacement over the lag
/// (Einstein 1905; Mostoufi & Chaouki 2001), the motion of the bed as a whole removed:
///   msd(lag) = <(dx - <dx>)^2> over the particles, mean over 16 origins spread over the frames.
/// What circulates still counts, unlike in `mechanisms`. The slope is by least squares over the lags at which
/// the root of msd lies between a diameter and a quarter of the bed's width, of its mean height along y:
/// before walls hold particles up.
///
/// Table "dispersion": lag up to half of the time, s; msd_x, msd_y, m2.
class Dispersion final : public Analysis {
 public:
  explicit Dispersion(const AnalysisInput& input);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override { return {{"dispersion", table()}}; }
  std::vector<FoundNumber> findings() const override;

 private:
  struct Origin {
    std::size_t index;  // of its frame
    std::vector<std::int32_t> id;
    std::vector<Vec2f> position;
  };
  struct Sum {
    int origins = 0;
    Vec2 msd{};
  };
  Table table() const;

  const Scene& scene_;
  Paths paths_;
  double interval_;       // s
  double heights_ = 0.0;  // of the bed, summed, m
  std::size_t every_;     // frames between origins
  std::size_t seen_ = 0;
  std::vector<Origin> origins_;
  std::vector<Sum> sums_;  // by lag in frames, from 1
};

}  // namespace bedmix
