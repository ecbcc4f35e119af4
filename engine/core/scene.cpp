// SPDX-License-Identifier: MIT
#include "engine/core/scene.h"

#include <cmath>
#include <numbers>

namespace bedmix {

using std::numbers::pi;

double particleVolume(const Scene& scene) {
  const double d = scene.particles.diameter;
  return pi / 6.0 * d * d * d;
}

double particleMass(const Scene& scene) { return particleVolume(scene) * scene.particles.density; }

double dampingFor(double restitution, double stiffness, double reducedMass) {
  const double logE = std::log(restitution);
  return -2.0 * logE / std::sqrt(pi * pi + logE * logE) * std::sqrt(reducedMass * stiffness);
}

double pairDamping(const Scene& scene) {
  const ContactSettings& c = scene.contacts;
  return c.damping ? *c.damping
                   : dampingFor(c.restitution.value_or(1.0), c.stiffness, particleMass(scene) / 2);
}

double wallDamping(const Scene& scene) {
  const ContactSettings& c = scene.contacts;
  return c.damping ? *c.damping : dampingFor(c.restitution.value_or(1.0), c.stiffness, particleMass(scene));
}

double contactTimeScale(const Scene& scene) {
  return 2.0 * pi * std::sqrt(particleMass(scene) / scene.contacts.stiffness);
}

double minimumFluidizationVelocity(const Scene& scene) {
  const GasSettings& g = *scene.gas;
  if (g.minimumFluidizationVelocity) return *g.minimumFluidizationVelocity;
  const double d = scene.particles.diameter;
  const double archimedes = d * d * d * g.density * (scene.particles.density - g.density) * scene.gravity /
                            (g.viscosity * g.viscosity);
  const double reynolds = std::sqrt(33.7 * 33.7 + 0.0408 * archimedes) - 33.7;
  return reynolds * g.viscosity / (g.density * d);
}

double inletVelocity(const Scene& scene, const Inlet& inlet) {
  return inlet.velocity ? *inlet.velocity : *inlet.velocityUmf * minimumFluidizationVelocity(scene);
}

double floorHeight(const Scene& scene, double x) {
  return x * std::tan(scene.floor.inclinationDeg * pi / 180.0);
}

std::int64_t stepsPerFrame(const Scene& scene) {
  return std::llround(scene.sampling.interval / scene.time.step);
}
std::int64_t stepsPerGasStep(const Scene& scene) { return std::llround(scene.gas->step / scene.time.step); }
std::int64_t totalSteps(const Scene& scene) { return std::llround(scene.time.duration / scene.time.step); }

double timeOfStep(const Scene& scene, std::int64_t step) {
  const double rate = 1.0 / scene.time.step;
  const double whole = std::round(rate);
  const bool isWhole = std::abs(rate - whole) < 1e-9 * rate;
  return isWhole ? static_cast<double>(step) / whole : static_cast<double>(step) * scene.time.step;
}

}  // namespace bedmix
