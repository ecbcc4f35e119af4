// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/models.h"

#include <cstddef>

namespace bedmix {

/// What the drag laws need to know of gas and particles.
struct DragProperties {
  double diameter;    // m
  double gasDensity;  // kg/m3
  double viscosity;   // Pa s
};

/// Voidage above which Tian et al. (2007) change from Ergun to Wen & Yu.
inline constexpr double dilute = 0.8;

/// Drag per volume of particles and slip, beta / (1 - eps), kg/(m3 s), for `n` voidages in (0, 1] and slips
/// |u_gas - v_particle| >= 0, m/s; finite at no slip and at voidage 1. The same bits on every machine.
void evaluateDragLaw(DragLaw law, const DragProperties& properties, std::size_t n, const double* voidage,
                     const double* slip, double* drag);

}  // namespace bedmix
