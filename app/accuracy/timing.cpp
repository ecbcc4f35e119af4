// SPDX-License-Identifier: MIT
#include "app/accuracy/timing.h"

#include "app/accuracy/scene_steps.h"
#include "app/accuracy/start_states.h"
#include "engine/simulation.h"

#include <chrono>

namespace bedmix {

void measureTime(const Scene& scene, const Particles& start, double stretch, Sample& into) {
  Simulation simulation = Simulation::make(scene, start);
  const auto begin = std::chrono::steady_clock::now();
  auto trouble = simulation.advance(ticksIn(scene, stretch));
  into.set(measure::wall, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  into.set(measure::simulated, simulation.time());
  if (trouble) {
    into.failure = *trouble;
    return;
  }
  const StageSeconds& stages = simulation.stageSeconds();
  double particles = 0.0;
  for (const Stage s : {Stage::neighbours, Stage::contacts, Stage::integrate})
    particles += stages[static_cast<std::size_t>(s)];
  into.set(measure::demWall, particles / simulation.time() / static_cast<double>(scene.particles.count));
  into.set(measure::steps, static_cast<double>(simulation.particleSteps()) / simulation.time());
  into.set(measure::gasSteps, static_cast<double>(simulation.gasSteps()) / simulation.time());
}

}  // namespace bedmix
