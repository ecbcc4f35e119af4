// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/period.h"
#include "engine/core/sampling_grid.h"
#include "replay/analysis/analysis.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace bedmix {

/// Which of Lacey's (1954) three mechanisms moves the particles. What a particle at r from the centroid of
/// its sampling cell moves by between two frames is split by least squares over the cell,
///   D = U + G r + w:
/// convective, with its neighbours; shear, by the gradient of their motion; diffusive, on its own. The mean
/// squares of the three add up to that of D. Cells with fewer than `sampling.min_particles` are not split.
///
/// Of the motion, only what lasts mixes. So the parts are also summed along each particle's path: over a lag
/// the covariance of each part's sum with the displacement is its share of the mean-square displacement, and
/// the shares add up to it; "dilute" is what was moved in cells that are not split.
///
/// Tables "mechanisms", m2/s2 between frames, and "mechanisms_lag", m2 over lags of 1, 2, 4, ... frames.
class Mechanisms final : public Analysis {
 public:
  explicit Mechanisms(const AnalysisInput& input);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override;
  std::vector<FoundNumber> findings() const override;

 private:
  enum Part { convective, shear, diffusive, dilute };
  using Parts = std::array<Vec2, 4>;  // of a displacement, m
  /// What particles moved by within some time.
  struct Moves {
    std::vector<std::int32_t> id;
    std::vector<Parts> parts;
    double duration = 0.0;  // s
  };
  /// Sums over the paths of one length.
  struct Lag {
    std::optional<Moves> waiting;  // for the next as long, to make one twice as long
    int windows = 0;
    double duration = 0.0;
    double paths = 0.0;
    Vec2 square{};     // of the displacement
    Parts products{};  // of each part and the displacement
  };

  Moves split(const Frame& frame);
  void sum(Moves moves);
  Table lagTable() const;

  SamplingGrid grid_;
  Period period_;
  double width_;    // m, of the bed
  Frame previous_;  // time, places and ids only
  bool started_ = false;
  std::vector<Lag> lags_;
  Table table_;
};

}  // namespace bedmix
