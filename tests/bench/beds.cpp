// SPDX-License-Identifier: MIT
#include "tests/bench/beds.h"

#include "engine/core/rng.h"
#include "engine/core/walls.h"
#include "engine/dem/packing.h"
#include "engine/dem/particle_solver.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace bedmix::bench {

namespace {

/// Benchmarks have nobody to hand a problem to.
[[noreturn]] void fail(const std::string& what) { throw std::runtime_error("bench: " + what); }

}  // namespace

Scene bedScene(std::int64_t particles) {
  Scene scene;
  scene.particles.count = particles;
  scene.bed.width = 0.096 * static_cast<double>(particles) / 1000.0;
  scene.contacts.damping = 0.015;
  scene.contacts.friction = FrictionSettings{.dampingRatio = 1.0};
  return scene;
}

Scene gasScene(std::int64_t particles, std::int64_t columns) {
  Scene scene = bedScene(particles);
  scene.gas.emplace();
  scene.gas->grid.columns = {{columns * particles / 1000, 0.096 / static_cast<double>(columns)}};
  scene.gas->grid.rows = {{15, 0.012}, {12, 0.020}};
  scene.gas->inlets = {{0.0, scene.bed.width, std::nullopt, 2.0}};
  return scene;
}

Particles packedBed(std::int64_t particles) {
  const Scene one = bedScene(1000);
  const Result<Particles> settled = packBed(one);
  if (!settled) fail(settled.problems.front().message);
  std::vector<Vec2> positions;
  for (std::int64_t k = 0; k < particles / 1000; ++k)
    for (const Vec2 at : settled->position)
      positions.push_back(at + Vec2{static_cast<double>(k) * one.bed.width, 0.0});
  return makeParticles(bedScene(particles), positions);
}

Particles agitatedBed(std::int64_t particles) {
  const Scene scene = bedScene(particles);
  const double d = scene.particles.diameter, spacing = 1.15 * d;
  const auto columns = static_cast<std::int64_t>((scene.bed.width - d) / spacing) + 1;
  const double left = (scene.bed.width - static_cast<double>(columns - 1) * spacing) / 2.0;
  std::vector<Vec2> positions;
  for (std::int64_t i = 0; i < particles; ++i)
    positions.push_back(
        {left + static_cast<double>(i % columns) * spacing, d + static_cast<double>(i / columns) * spacing});
  Particles start = makeParticles(scene, positions);
  Rng rng(scene.seed);
  for (Vec2& v : start.velocity) {
    const double angle = rng.uniform(0.0, 2.0 * std::numbers::pi);
    v = {0.5 * std::cos(angle), 0.5 * std::sin(angle)};
  }
  const auto solver = ParticleSolver::make(scene, std::move(start), bedWalls(scene));
  if (solver->advance(500)) fail("the agitated bed became invalid");
  return inOrderOfIds(solver->particles());
}

Result<Particles> readBed(const std::string& path, std::int64_t tiles) {
  std::ifstream file(path);
  if (!file) return Diagnostic({path}, "cannot be read; give a file of rows `x y vx vy`", Trouble::file);
  std::vector<Vec2> positions, velocities;
  Vec2 position, velocity;
  while (file >> position.x >> position.y >> velocity.x >> velocity.y) {
    positions.push_back(position);
    velocities.push_back(velocity);
  }
  if (!file.eof() || positions.empty())
    return Diagnostic({path, static_cast<int>(positions.size()) + 1, 1},
                      "not a row of four numbers x y vx vy");
  const std::size_t one = positions.size(), all = one * static_cast<std::size_t>(tiles);
  const double width = bedScene(static_cast<std::int64_t>(one)).bed.width;
  positions.reserve(all);
  velocities.reserve(all);
  for (std::size_t i = one; i < all; ++i) {
    positions.push_back(positions[i - one] + Vec2{width, 0.0});
    velocities.push_back(velocities[i - one]);
  }
  Particles bed = makeParticles(bedScene(static_cast<std::int64_t>(all)), positions);
  velocities.shrink_to_fit();
  bed.velocity = std::move(velocities);
  return bed;
}

}  // namespace bedmix::bench
