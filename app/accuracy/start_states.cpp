// SPDX-License-Identifier: MIT
#include "app/accuracy/start_states.h"

#include "app/accuracy/scene_steps.h"
#include "engine/dem/packing.h"
#include "engine/simulation.h"

#include <algorithm>
#include <cmath>

namespace bedmix {

namespace {

constexpr double mostDevelopment = 1.0;             // s
constexpr double shareWithGas = 0.25, share = 0.1;  // of a run; without gas it comes to rest

}  // namespace

Particles particlesOf(const Scene& scene, const Frame& frame) {
  std::vector<Vec2> positions;
  for (const Vec2f p : frame.position) positions.push_back({p.x, p.y});
  Particles particles = makeParticles(scene, positions);
  for (std::size_t i = 0; i < frame.size(); ++i)
    particles.velocity[i] = {frame.velocity[i].x, frame.velocity[i].y};
  for (std::size_t i = 0; i < frame.angularVelocity.size(); ++i) particles.spin[i] = frame.angularVelocity[i];
  return particles;
}

const Result<Particles>& StartStates::settled(const Setting& setting, int seedOffset) {
  const double stiffness = normalStiffness(setting.scene);
  return settled_.get({stiffness, seedOffset}, [&] {
    Scene scene = scene_;
    scene.seed += static_cast<std::uint64_t>(seedOffset);
    scene.contacts = setting.scene.contacts;
    if (!scene.time.step.isAutomatic())
      scene.time.step = scene_.time.step * std::min(1.0, std::sqrt(normalStiffness(scene_) / stiffness));
    return packBed(scene);
  });
}

double StartStates::developedAfter() const {
  const double wanted = std::min(mostDevelopment, (scene_.gas ? shareWithGas : share) * scene_.time.duration);
  return std::max(1.0, std::round(wanted / scene_.sampling.interval)) * scene_.sampling.interval;
}

const Result<Particles>& StartStates::developed(int seedOffset) {
  return developed_.get(seedOffset, [&]() -> Result<Particles> {
    const Result<Particles>& start = settled({std::string(sceneItself), scene_}, seedOffset);
    if (!start) return start.problems;
    Simulation simulation = Simulation::make(scene_, *start);
    if (auto trouble = simulation.advance(ticksIn(scene_, developedAfter())))
      return Diagnostic{{scene_.name}, *trouble};
    return particlesOf(scene_, *simulation.frame());
  });
}

}  // namespace bedmix
