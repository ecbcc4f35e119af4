// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"

#include <optional>
#include <utility>
#include <vector>

namespace bedmix {

/// How much positions still tell of where particles started, after Doucet, Bertrand & Chaouki (2008), Chem.
/// Eng. Res. Des. 86:1313, in a plane: with C_ij the correlation of coordinate i now and j at the start, C^T
/// C has the eigenvalues 1 for particles that kept their places, and of the order of 1/N for such as forgot
/// them.
class StartCorrelation {
 public:
  struct PrincipalComponent {
    double index = 0.0;  // largest eigenvalue over that at the start: 1 there, 0 for no memory
    double angle = 0.0;  // of its eigenvector, from x, in [-pi/2, pi/2]: the start that is remembered best,
                         // in coordinates over their standard deviations, so that what mixes worst
  };

  explicit StartCorrelation(const Frame& start);

  /// Of the particles that have been there from the start, found by id; empty without ids or where one of the
  /// four coordinates is the same for all.
  std::optional<PrincipalComponent> with(const Frame& frame) const;

 private:
  std::vector<std::pair<std::int32_t, Vec2f>> start_;  // by id
};

}  // namespace bedmix
