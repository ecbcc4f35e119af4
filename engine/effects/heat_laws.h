// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"

#include <cstddef>

namespace bedmix {

/// Nusselt numbers h d / k_gas of particles in gas, Gunn (1978), Int. J. Heat Mass Transfer 21:467:
///   Nu = (7 - 10 e + 5 e^2)(1 + 0.7 Re^0.2 Pr^1/3) + (1.33 - 2.4 e + 1.2 e^2) Re^0.7 Pr^1/3,
/// Re = e rho |u - v| d / mu, for voidages e from 0.35 to 1 and Re up to 1e5. The same bits on every machine.
void gunnNusselt(double prandtl, std::size_t n, const double* voidage, const double* reynolds,
                 double* nusselt);

/// What passes between particles and gas, whose temperature stays what it is, in a step: the mean of h A over
/// it as the particle comes closer, so that however strong the exchange, none goes beyond the gas.
struct ConvectionLaw {
  explicit ConvectionLaw(const Scene& scene);  // with heat and gas

  /// Of some particles.
  struct Batch {
    std::size_t size;
    const double *voidage, *slip;  // -, and |u - v| where d is scene.particles.diameter, m/s: for others such
                                   // as gives the same Reynolds number
    const double* length;          // pi d, m, as far as coupled to the gas
    const double* heatCapacity;    // J/K
  };
  /// W/K
  void conductances(double step, const Batch& batch, double* conductance) const;

  double prandtl;
  double reynoldsPerSlip;  // s/m, at voidage 1
  double conductivity;     // W/(m K)
};

/// Through contacts, Batchelor & O'Brien (1977), Proc. R. Soc. Lond. A 355:313: 2 k a between spheres and 4 k
/// a to a wall that has one temperature, a the radius of the area of contact. Of linear springs this is that
/// of the overlap, a^2 = 2 R d, 1/R = 1/R_1 + 1/R_2, of Hertzian ones a^2 = R d; softer than the solid by
/// far, they make it far too wide. With the solid's elastic constants it is that which the spring's force F
/// makes on the solid, Hertz (1882): a^3 = 3 F R / (4 E*), 1/E* = 2 (1 - nu^2)/E.
struct ConductionLaw {
  explicit ConductionLaw(const Scene& scene);  // with heat

  /// m, at an overlap (m) of bodies of reduced radius R (m).
  double contactRadius(double overlap, double reducedRadius) const;
  /// W/K
  double pair(double overlap, double reducedRadius) const {
    return 2.0 * conductivity * contactRadius(overlap, reducedRadius);
  }
  double wall(double overlap, double radius) const {
    return 4.0 * conductivity * contactRadius(overlap, radius);
  }

  double conductivity;       // W/(m K)
  double cubePerArea = 0.0;  // a^3 over overlap and R, m; or, where that is 0,
  double square = 2.0;       // a^2 over overlap and R
};

}  // namespace bedmix
