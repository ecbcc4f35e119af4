// SPDX-License-Identifier: MIT
#pragma once

#include "engine/coupling/exchange.h"

#include <vector>

namespace bedmix::test {

/// Gas through particles that are held in place.
struct FixedBed {
  Scene scene;
  Particles particles;
  ThreadTeam team{1};
  GasSolver gas;
  VoidageField voidage;
  Exchange exchange;

  FixedBed(const Scene& s, const std::vector<Vec2>& centres)
      : scene(s),
        particles(makeParticles(s, centres)),
        gas(s, team),
        voidage(s, gas.grid(), team),
        exchange(s, gas, voidage, team) {
    particles.addExternalForces();
    voidage.update(particles.position);
    gas.startWith(voidage.voidage());
  }
  GasStepReport step() {
    voidage.update(particles.position);
    exchange.evaluateDrag(particles, gas.exchange());
    const GasStepReport r = gas.advance(voidage.voidage());
    exchange.applyForces(particles);
    return r;
  }
};

/// Pa/m, at voidage eps and superficial velocity u (m/s).
inline double ergunGradient(double eps, double u, const Scene& s) {
  const double d = s.particles.diameter, mu = s.gas->viscosity, rho = s.gas->density, e3 = eps * eps * eps;
  return 150 * (1 - eps) * (1 - eps) * mu * u / (e3 * d * d) + 1.75 * (1 - eps) * rho * u * u / (e3 * d);
}

}  // namespace bedmix::test
