// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "replay/analysis/analysis.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace bedmix {

/// How long particles stay in the lower and the upper half of the bed and near the distributor, and after
/// what time they are back there. The halves are those of the particles, by height above the floor, so that
/// no one changes sides as the bed heaves as a whole; near is within three diameters of the floor. A particle
/// must be a diameter beyond a border to have crossed it.
///
/// Means are the particles' time in a zone over the number of times one left it, which stays cut off at
/// either end of the frames do not bias; a cycle is a stay in either half. The distribution is of whole
/// stays.
///
/// Table "residence": from, to, s; numbers of stays that long: lower, upper, near, away (from the
/// distributor), cycle (from one fall into the lower half to the next).
class Residence final : public Analysis {
 public:
  explicit Residence(const AnalysisInput& input);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override;
  std::vector<FoundNumber> findings() const override;

 private:
  enum Zone { lower, upper, near, away, cycle };
  struct Particle {
    bool isUpper = false, isNear = false;
    // When it came, s; empty where that was before the frames began.
    std::optional<double> half{}, distributor{}, fall{};
  };
  struct Stays {
    double time = 0.0;  // s, of all particles
    double ends = 0.0;
    std::vector<double> byLength;
  };
  void end(Zone zone, const std::optional<double>& since, double now);
  std::optional<double> mean(Zone zone) const;

  const Scene& scene_;
  double shortest_;  // s, lower end of the first class of lengths
  double time_ = 0.0;
  std::vector<std::int32_t> ids_;
  std::vector<Particle> particles_;
  std::array<Stays, 5> stays_;
};

}  // namespace bedmix
