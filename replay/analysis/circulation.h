// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/sampling_grid.h"
#include "replay/analysis/analysis.h"

#include <vector>

namespace bedmix {

/// The mean motion of the solids over all frames: in each cell the mean velocity of the particles, counting
/// each particle each time, and the mean fraction of the cell's volume that they fill.
///
/// How much goes round, kg/s, is the range of the stream function psi(x, y) = int_0^x j dx', where j is the
/// mean mass that rises at height y per width of the bed; the solids' mass over it is the turnover time.
///
/// Tables "circulation", on cells of two diameters, and "circulation_cells", on the sampling cells: x, y of
/// the centre, m; particles in the cell; u, v, m/s; solids_fraction.
class Circulation final : public Analysis {
 public:
  explicit Circulation(const AnalysisInput& input);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override;
  std::vector<FoundNumber> findings() const override;

 private:
  struct Sum {
    double n = 0.0;
    Vec2 velocity{};
  };
  struct Field {
    SamplingGrid grid;
    std::vector<Sum> sums;
  };
  Table tableOf(const Field& field) const;

  double particleMass_, particleVolume_, thickness_;
  double frames_ = 0.0, particles_ = 0.0;  // particles: summed over the frames
  Field fine_, coarse_;
};

}  // namespace bedmix
