// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene.h"
#include "engine/core/vec2.h"
#include "engine/simulation.h"

#include <utility>
#include <vector>

namespace bedmix::test {

/// The paper's bed with gas and one inlet over the whole floor, in its own numbers; change what a test needs.
inline Scene paperScene(double superficialVelocity) {
  Scene scene;
  scene.contacts.restitution = 0.9;
  scene.contacts.friction.emplace();
  scene.gas.emplace();
  scene.gas->grid.columns = {{8, 0.012}};
  scene.gas->grid.rows = {{15, 0.012}, {12, 0.020}};
  scene.gas->inlets = {{0.0, scene.bed.width, superficialVelocity, std::nullopt}};
  return scene;
}

/// A bed of half the width and 120 mm height: quick, with everything in it.
inline Scene lowScene(std::int64_t particles, double superficialVelocity) {
  Scene scene = paperScene(superficialVelocity);
  scene.bed.width = 0.048;
  scene.bed.height = 0.12;
  scene.particles.count = particles;
  scene.gas->grid.columns = {{4, 0.012}};
  scene.gas->grid.rows = {{10, 0.012}};
  scene.gas->inlets = {{0.0, 0.048, superficialVelocity, std::nullopt}};
  return scene;
}

/// The same as case B of Tian et al. (2007): a stair of blocked cells, two inlets at the side walls.
inline Scene inclinedScene() {
  Scene scene = paperScene(0.0);
  scene.floor.inclinationDeg = 18.0;
  scene.gas->inlets = {{0.0, 0.024, std::nullopt, 5.0}, {0.072, 0.096, std::nullopt, 3.0}};
  return scene;
}

/// A simulation of a scene that is known to be in order.
inline Simulation simulate(const Scene& scene, int threads = 1) {
  Result<Simulation> made = Simulation::make(scene, threads);
  return std::move(made.value).value();
}

/// Centres of a square lattice of touching spheres that fills the bed.
inline std::vector<Vec2> squareLattice(const Scene& scene) {
  const double d = scene.particles.diameter;
  std::vector<Vec2> centres;
  for (double y = d / 2; y < scene.bed.height; y += d)
    for (double x = d / 2; x < scene.bed.width; x += d) centres.push_back({x, y});
  return centres;
}

}  // namespace bedmix::test
