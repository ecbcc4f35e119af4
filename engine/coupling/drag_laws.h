// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/models.h"

#include <cmath>

// Drag laws as pure functions. Each returns the momentum exchange coefficient beta, kg/(m3 s), for
// voidage eps in (0, 1), slip = |u_gas - v_particle| >= 0 in m/s, and is finite at zero slip.

namespace bedmix {

/// What the drag laws need to know of gas and particles.
struct DragProperties {
  double diameter;    // m
  double gasDensity;  // kg/m3
  double viscosity;   // Pa s
};

/// Ergun (1952); Tian et al. (2007), Eq. (3a).
inline double ergunDrag(double voidage, double slip, const DragProperties& p) {
  const double solids = 1.0 - voidage;
  return 150.0 * solids * solids * p.viscosity / (voidage * p.diameter * p.diameter) +
         1.75 * solids * p.gasDensity * slip / p.diameter;
}

/// Drag coefficient times Reynolds number of a single sphere, Tian et al. (2007), Eq. (4): finite at Re = 0.
inline double sphereDragTimesReynolds(double reynolds) {
  return reynolds < 1000.0 ? 24.0 * (1.0 + 0.15 * std::pow(reynolds, 0.687)) : 0.43 * reynolds;
}

/// Wen & Yu (1966); Tian et al. (2007), Eq. (3b), consistent with Eqs (2) and (9):
/// 3/4 C_D eps (1-eps) rho slip/d eps^-2.65, Re = rho eps d slip / mu.
inline double wenYuDrag(double voidage, double slip, const DragProperties& p) {
  const double reynolds = p.gasDensity * voidage * p.diameter * slip / p.viscosity;
  return 0.75 * sphereDragTimesReynolds(reynolds) * (1.0 - voidage) * p.viscosity /
         (p.diameter * p.diameter) * std::pow(voidage, -2.65);
}

/// Voidage above which Tian et al. (2007) change from Ergun to Wen & Yu.
inline constexpr double dilute = 0.8;

inline double ergunWenYuDrag(double voidage, double slip, const DragProperties& p) {
  return voidage <= dilute ? ergunDrag(voidage, slip, p) : wenYuDrag(voidage, slip, p);
}

/// Eq. (3b) as the paper prints it, without the factor eps before (1-eps).
inline double ergunWenYuPrintedDrag(double voidage, double slip, const DragProperties& p) {
  return voidage <= dilute ? ergunDrag(voidage, slip, p) : wenYuDrag(voidage, slip, p) / voidage;
}

using DragFunction = double (*)(double voidage, double slip, const DragProperties& p);

constexpr DragFunction dragFunction(DragLaw law) {
  switch (law) {
    case DragLaw::ergunWenYu:
      return ergunWenYuDrag;
    case DragLaw::ergunWenYuPrinted:
      return ergunWenYuPrintedDrag;
    case DragLaw::ergun:
      return ergunDrag;
    case DragLaw::wenYu:
      return wenYuDrag;
  }
  return nullptr;
}

}  // namespace bedmix
