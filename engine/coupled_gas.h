// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/inlet_flow.h"
#include "engine/coupling/exchange.h"
#include "engine/coupling/gas_step.h"
#include "engine/coupling/voidage.h"
#include "engine/dem/particles.h"
#include "engine/gas/gas_solver.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace bedmix {

/// The gas and all that ties it to the particles. One allocation, since its parts point at each other.
struct CoupledGas {
  GasSolver solver;
  VoidageField voidage;
  Exchange exchange;
  std::optional<GasStep> chosenStep;  // where the scene gives none
  MomentumExchange drag;              // beside it, where effects charge the gas: what that got without them
  std::optional<InletFlow> flow;      // where what enters changes in time

  CoupledGas(const Scene& scene, Particles& particles, ThreadTeam& team)
      : solver(scene, team), voidage(scene, solver.grid(), team), exchange(scene, solver, voidage, team) {
    if (scene.gas->step.isAutomatic()) chosenStep.emplace(scene, solver);
    setInlets(scene);
    particles.addExternalForces();
    voidage.update(particles.position, particles.radii);
  }

  void setInlets(const Scene& scene) {
    flow.reset();
    if (InletFlow::changes(scene)) flow.emplace(scene, makeGasGrid(scene));
  }
  /// The longest that the coming step may be, s.
  double longestStep() {
    if (!flow) return chosenStep->longest();
    chosenStep->expect(solver, flow->fastest());
    return std::min(chosenStep->longest(), flow->longestStep());
  }

  void setStep(double seconds) {
    if (!chosenStep) return;
    solver.setStep(seconds);
    exchange.setStep(seconds);
  }
  void start(double step) {
    setStep(step);
    solver.startWith(voidage.voidage());
  }
};

/// The gas of a frame.
inline GasFrame gasFrame(const GasSolver& gas) {
  const GasFields& fields = gas.fields();
  const std::size_t cells = gas.grid().cells();
  GasFrame out{std::vector<float>(cells, 1.0f), std::vector<float>(cells), std::vector<Vec2f>(cells), {}};
  for (int c : gas.layout().openCells) {
    const auto& [left, right, bottom, top] = gas.layout().cellFaces[c];
    out.voidage[c] = static_cast<float>(fields.voidage[c]);
    out.pressure[c] = static_cast<float>(fields.pressure[c]);
    out.velocity[c] = toFloat({0.5 * (fields.velocity[left] + fields.velocity[right]),
                               0.5 * (fields.velocity[bottom] + fields.velocity[top])});
  }
  return out;
}

}  // namespace bedmix
