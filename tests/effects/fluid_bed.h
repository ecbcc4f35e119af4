// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/walls.h"
#include "engine/coupling/exchange.h"
#include "engine/dem/particle_solver.h"
#include "engine/effects/effect_stage.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

namespace bedmix::test {

/// A bed in a gas whose velocity is given, with the effects of its scene; every part can be looked at.
struct FluidBed {
  Scene scene;
  ThreadTeam team;
  std::unique_ptr<ParticleSolver> solver;
  std::unique_ptr<GasSolver> gas;
  std::unique_ptr<VoidageField> voidage;
  std::unique_ptr<Exchange> exchange;
  std::vector<double> temperature;  // K
  std::vector<std::unique_ptr<EffectStage>> effects;
  MomentumExchange drag;  // what the gas got without the effects at the last charge

  FluidBed(const Scene& s, const std::vector<Vec2>& centres, int threads = 1) : scene(s), team(threads) {
    scene.particles.count = static_cast<std::int64_t>(centres.size());
    solver = ParticleSolver::make(scene, makeParticles(scene, centres), bedWalls(scene), team);
    gas = std::make_unique<GasSolver>(scene, team);
    voidage = std::make_unique<VoidageField>(scene, gas->grid(), team);
    exchange = std::make_unique<Exchange>(scene, *gas, *voidage, team);
    particles().addExternalForces();
    voidage->update(particles().position, particles().radii);
    gas->startWith(voidage->voidage());
    effects = effectStages({scene, *solver, gas.get(), voidage.get(), exchange.get(), team, temperature});
  }
  Particles& particles() { return solver->particles(); }

  /// Sets the gas's velocity on every face to that of a field of places.
  template <class Field>
  void setVelocity(const Field& field) {
    const GasGrid& g = gas->grid();
    const FaceLayout& layout = gas->layout();
    std::vector<double> velocity(gas->fields().velocity.size(), 0.0);
    const auto middle = [](const std::vector<double>& faces, int k) {
      return 0.5 * (faces[static_cast<std::size_t>(k)] + faces[static_cast<std::size_t>(k) + 1]);
    };
    for (int j = 0; j < g.rows; ++j)
      for (int i = 0; i <= g.columns; ++i)
        velocity[static_cast<std::size_t>(layout.uFace(i, j))] = field(Vec2{g.x[i], middle(g.y, j)}).x;
    for (int j = 0; j <= g.rows; ++j)
      for (int i = 0; i < g.columns; ++i)
        velocity[static_cast<std::size_t>(layout.vFace(i, j))] = field(Vec2{middle(g.x, i), g.y[j]}).y;
    StateWriter out(0);
    gas->save(out);
    std::vector<std::byte> bytes = out.take();
    // Behind a number, the inlets' list and the length of this one.
    const std::size_t before = 8 + 8 + 8 * g.inletFlux.size() + 8;
    std::memcpy(bytes.data() + before, velocity.data(), 8 * velocity.size());
    StateReader in(bytes);
    ASSERT_TRUE(gas->load(in) && in.done());
  }
  /// What gas and particles give each other at the start of a step.
  void charge() {
    voidage->update(particles().position, particles().radii);
    exchange->evaluateDrag(particles(), gas->exchange());
    drag = gas->exchange();
    for (const auto& effect : effects) effect->chargeGas(scene.gas->step, gas->exchange());
  }
  /// Sets the particles' forces; those of the effects alone are returned.
  std::vector<Vec2> act() {
    exchange->applyForces(particles());
    const std::vector<Vec2> before = particles().external;
    for (const auto& effect : effects) effect->act(scene.gas->step, scene.gas->step);
    std::vector<Vec2> added;
    for (std::size_t i = 0; i < before.size(); ++i) added.push_back(particles().external[i] - before[i]);
    return added;
  }
  /// That the effects put on the gas, N, as it is now.
  Vec2 onGas() const {
    Vec2 sum;
    const std::vector<double>& velocity = gas->fields().velocity;
    for (std::size_t f = 0; f < drag.source.size(); ++f) {
      const double force = gas->exchange().source[f] - drag.source[f] -
                           (gas->exchange().coefficient[f] - drag.coefficient[f]) * velocity[f];
      (f < static_cast<std::size_t>(gas->layout().size) ? sum.x : sum.y) += force;
    }
    return sum;
  }
};

}  // namespace bedmix::test
