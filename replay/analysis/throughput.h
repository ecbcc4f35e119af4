// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "replay/analysis/analysis.h"

#include <cstdint>
#include <map>
#include <vector>

namespace bedmix {

/// Continuous operation: how many leave, how many are there, and how long those who came in stay (residence
/// times). A stay is from the first frame with a particle to the first without it. Who is still there at the
/// end has stayed for at least as long: the share F(t) that has left is after Kaplan & Meier (1958), which
/// such stays do not bias; from it come mean, variance, and the number of stirred tanks in series with that
/// variance. A single stirred tank has F = 1 - exp(-t/tau). In a steady state the mean is those there over
/// those who leave in a second, whatever the bed does (Danckwerts 1953).
///
/// Table "residence_times": time, s; left, stays that ended since the time before; density, 1/s; share F;
/// stirred, F of a stirred tank of the same mean.
class Throughput final : public Analysis {
 public:
  explicit Throughput(const AnalysisInput& input);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override;
  std::vector<FoundNumber> findings() const override;

 private:
  /// Stays that ended, and that went on for as long, by length in whole microseconds, so that the same
  /// number of frames is the same length.
  struct Stays {
    double ended = 0.0, goOn = 0.0;
  };
  std::map<std::int64_t, Stays> stays() const;
  /// F at each length at which stays ended, and its first two moments.
  struct Shares {
    std::vector<double> time, left, share;
    double mean = 0.0, variance = 0.0;
  };
  Shares shares() const;
  /// Those there over those who leave in a second, s.
  std::optional<double> holdUpOverOutflow() const;

  const Scene& scene_;
  struct Present {
    std::int32_t id;
    double since;  // s; of those who were there at the start the first frame's
  };
  std::vector<Present> present_;                   // by id
  std::vector<double> stays_;                      // s
  double begin_ = 0.0, now_ = 0.0, holdUp_ = 0.0;  // s, s, particles times s
  double left_ = 0.0, entered_ = 0.0;
  std::int32_t newest_ = -1;
  bool begun_ = false;
};

}  // namespace bedmix
