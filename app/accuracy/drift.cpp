// SPDX-License-Identifier: MIT
#include "app/accuracy/contact_errors.h"
#include "app/accuracy/scene_steps.h"
#include "app/accuracy/start_states.h"
#include "engine/core/rng.h"
#include "engine/simulation.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr int side = 8;          // spheres along a side of the box
constexpr double spacing = 1.6;  // diameters
constexpr int chunks = 100;      // of sqrt(d/g)

/// J, over k/2 for springs and m/2 for motion.
double energyOf(const Frame& frame, const Scene& scene) {
  const double d = scene.particles.diameter, m = particleMass(scene), k = normalStiffness(scene);
  double motion = 0.0, springs = 0.0;
  const auto press = [&](double overlap) { springs += overlap > 0.0 ? overlap * overlap : 0.0; };
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Vec2 v{frame.velocity[i].x, frame.velocity[i].y}, p{frame.position[i].x, frame.position[i].y};
    motion += dot(v, v);
    for (const double gap : {p.x, p.y, scene.bed.width - p.x, scene.bed.height - p.y}) press(0.5 * d - gap);
    for (std::size_t j = 0; j < i; ++j) press(d - norm(p - Vec2{frame.position[j].x, frame.position[j].y}));
  }
  return 0.5 * m * motion + 0.5 * k * springs;
}

}  // namespace

bool measureDrift(const Scene& like, const std::function<bool()>& stop, Sample& into) {
  Scene scene = like;
  scene.gas.reset();
  scene.flux.reset();
  scene.floor = {};
  scene.gravity = 0.0;
  scene.contacts.friction.reset();
  scene.contacts.damping.reset();
  scene.contacts.restitution = 1.0;
  scene.particles.count = side * side;
  const double d = scene.particles.diameter, g = like.gravity > 0.0 ? like.gravity : 9.81;
  scene.bed = {.width = spacing * side * d, .height = spacing * side * d, .thickness = d, .top = BedTop::lid};

  std::vector<Vec2> places;
  for (int i = 0; i < side * side; ++i) places.push_back(spacing * d * Vec2{0.5 + i % side, 0.5 + i / side});
  Particles start = makeParticles(scene, places);
  Rng rng(1);
  const double most = 2.0 * std::sqrt(g * d);
  for (Vec2& v : start.velocity) v = {rng.uniform(-most, most), rng.uniform(-most, most)};

  Simulation simulation = Simulation::make(scene, std::move(start));
  const double before = energyOf(*simulation.frame(), scene);
  const std::int64_t chunk = ticksIn(scene, std::sqrt(d / g));
  for (int k = 0; k < chunks; ++k) {
    if (stop()) return false;
    if (auto trouble = simulation.advance(chunk)) {
      into.failure = *trouble;
      return true;
    }
  }
  into.set(measure::drift, std::abs(energyOf(*simulation.frame(), scene) / before - 1.0));
  return true;
}

}  // namespace bedmix
