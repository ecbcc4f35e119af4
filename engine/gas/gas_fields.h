// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace bedmix {

/// What the gas is at one time. Faces and cells are numbered as in FaceLayout.
struct GasFields {
  std::vector<double> velocity;  // per face: interstitial, m/s
  std::vector<double> pressure;  // per cell: Pa above the outlet's
  std::vector<double> voidage;   // per cell; 1 in blocked cells
};

/// What the particles do to the gas, per face: drag = source - coefficient * velocity. The coefficient goes
/// into the matrix, so that stiff drag costs no smaller step.
struct MomentumExchange {
  std::vector<double> coefficient;  // kg/s
  std::vector<double> source;       // N
};

}  // namespace bedmix
