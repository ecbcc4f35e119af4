// SPDX-License-Identifier: MIT
#include "engine/core/refinement.h"

#include <cmath>
#include <utility>

namespace bedmix {

namespace {

/// Of an automatic step, what it may err by is divided, and the step with it: its error grows with the
/// `order`th power of it.
void halve(StepLength& step, double& error, int order, std::int64_t times) {
  // By powers of two, so that it can be undone to the bit.
  if (step.isAutomatic())
    error = std::ldexp(error, -order * static_cast<int>(times));
  else
    step = std::ldexp(step, -static_cast<int>(times));
}

std::pair<std::string, double> setting(const std::string& table, const StepLength& step, double error) {
  if (step.isAutomatic()) return {table + ".error", error};
  return {table + ".step", step};
}

}  // namespace

Scene refined(Scene scene, Refinement further) {
  halve(scene.time.step, scene.time.error, 2, further.particles);
  if (scene.gas) halve(scene.gas->step, scene.gas->error, 1, further.gas);
  scene.refinement.particles += further.particles;
  scene.refinement.gas += further.gas;
  return scene;
}

Scene unrefined(Scene scene) {
  const Refinement undone{-scene.refinement.particles, -scene.refinement.gas};
  return refined(std::move(scene), undone);
}

RefinedSettings refinedSettings(const Scene& scene) {
  RefinedSettings settings;
  if (scene.refinement.particles > 0) settings.push_back(setting("time", scene.time.step, scene.time.error));
  if (scene.refinement.gas > 0) settings.push_back(setting("gas", scene.gas->step, scene.gas->error));
  return settings;
}

std::int64_t stepsPerStep(const Scene& fine, const Scene& coarse) {
  return stepsPerFrame(fine) / stepsPerFrame(coarse);
}

}  // namespace bedmix
