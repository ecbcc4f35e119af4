// SPDX-License-Identifier: MIT
#pragma once

#include "engine/gas/face_layout.h"

#include <vector>

namespace bedmix {

/// What the gas is at one time. Faces and cells are numbered as in FaceLayout.
struct GasFields {
  std::vector<double> velocity;     // per face incl. the zero face: interstitial, m/s
  std::vector<double> pressure;     // per cell: Pa above the outlet's
  std::vector<double> voidage;      // per cell; 1 in blocked cells
  std::vector<double> faceVoidage;  // per face incl. the zero face
};

/// What the particles do to the gas, per face: drag = source - coefficient * velocity. The coefficient goes
/// into the matrix, so that stiff drag costs no smaller step.
struct MomentumExchange {
  std::vector<double> coefficient;  // kg/s
  std::vector<double> source;       // N
};

/// Averages cell voidage onto the faces.
inline void updateFaceVoidage(const FaceLayout& layout, GasFields& gas) {
  for (std::size_t f = 0; f < layout.faceCells.size(); ++f) {
    const FaceLayout::FaceCells& c = layout.faceCells[f];
    gas.faceVoidage[f] = c.weightA * gas.voidage[c.a] + (1.0 - c.weightA) * gas.voidage[c.b];
  }
}

}  // namespace bedmix
