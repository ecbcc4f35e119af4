// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

#include <cstddef>

namespace bedmix {

/// What the gas does to a sphere across its slip w = u - v, and to its spin: ShearLift's and SpinLift's
/// models, of a sphere alone in the gas, Re = rho d |w|/mu. Mei's holds for 0.1 <= Re <= 100 and 0.005 <= b
/// <= 0.4, Lun & Liu's to Re = 1000, Dennis et al.'s to Re_s = 1000. The same bits on every machine.
struct LiftLaw {
  LiftLaw(const GasSettings& gas, const LiftSettings& lift)
      : density(gas.density), viscosity(gas.viscosity), models(lift) {}

  /// Of some particles.
  struct Batch {
    std::size_t size;
    const double *slip, *vorticity;  // |w|, m/s, and o, 1/s, counter-clockwise
    const double* spin;              // rad/s
    const double* diameter;          // m
  };
  /// What (w_y, -w_x) has to be multiplied by to give the force, kg/s, and -T/s, N m s.
  void evaluate(const Batch& batch, double* lift, double* resistance) const;

  double density, viscosity;  // of the gas, kg/m3, Pa s
  LiftSettings models;
};

}  // namespace bedmix
