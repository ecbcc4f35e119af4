// SPDX-License-Identifier: MIT
#include "engine/core/scene.h"

#include "engine/core/particle_list.h"

#include <algorithm>
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
  const double logE = std::abs(std::log(restitution));  // of an elastic one zero, not minus zero
  return 2.0 * logE / std::sqrt(pi * pi + logE * logE) * std::sqrt(reducedMass * stiffness);
}

double bedWeight(const Scene& scene) {
  const double mass = isMixed(scene) ? particleMeans(scene).mass
                                     : static_cast<double>(scene.particles.count) * particleMass(scene);
  return mass * scene.gravity / (scene.bed.width * scene.bed.thickness);
}

double lightestMass(const Scene& scene) {
  return isMixed(scene) ? particleRange(scene).lightest : particleMass(scene);
}

double normalStiffness(const Scene& scene) {
  const auto& hertz = scene.contacts.hertz;
  if (!hertz) return *scene.contacts.stiffness;
  const double radius = 0.5 * particleRange(scene).smallest;
  const double overlap = 2.0 * radius * scene.limits.warnOverlap;
  return 4.0 / 3.0 * effectiveModulus(*hertz) * std::sqrt(radius * overlap);
}

double elasticForce(const Scene& scene, double overlap, double effectiveRadius) {
  const auto& hertz = scene.contacts.hertz;
  if (!hertz) return *scene.contacts.stiffness * overlap;
  return 4.0 / 3.0 * effectiveModulus(*hertz) * std::sqrt(effectiveRadius * overlap) * overlap;
}

double effectiveModulus(const HertzSettings& hertz) {
  return 0.5 * hertz.youngsModulus / (1.0 - hertz.poissonRatio * hertz.poissonRatio);
}

double pairDamping(const Scene& scene) {
  const ContactSettings& c = scene.contacts;
  return c.damping ? *c.damping
                   : dampingFor(c.restitution.value_or(1.0), normalStiffness(scene), lightestMass(scene) / 2);
}

double wallDamping(const Scene& scene) {
  const ContactSettings& c = scene.contacts;
  return c.damping ? *c.damping
                   : dampingFor(c.restitution.value_or(1.0), normalStiffness(scene), lightestMass(scene));
}

double contactTimeScale(const Scene& scene) {
  return 2.0 * pi * std::sqrt(lightestMass(scene) / normalStiffness(scene));
}

double minimumFluidizationVelocity(const Scene& scene) {
  const GasSettings& g = *scene.gas;
  if (g.minimumFluidizationVelocity) return *g.minimumFluidizationVelocity;
  double d = scene.particles.diameter, density = scene.particles.density;
  if (isMixed(scene)) {
    const ParticleMeans means = particleMeans(scene);
    d = means.diameter;
    density = means.density;
  }
  const double archimedes =
      d * d * d * g.density * (density - g.density) * scene.gravity / (g.viscosity * g.viscosity);
  const double reynolds = std::sqrt(33.7 * 33.7 + 0.0408 * archimedes) - 33.7;
  return reynolds * g.viscosity / (g.density * d);
}

double inletVelocity(const Scene& scene, const Inlet& inlet) {
  return inlet.velocity ? *inlet.velocity : *inlet.velocityUmf * minimumFluidizationVelocity(scene);
}

double fastestInlet(const Scene& scene) {
  double fastest = 0.0;
  for (const Inlet& inlet : scene.gas->inlets) {
    const double factor = largestOf(inlet.schedule) * (inlet.pulse ? largestOf(*inlet.pulse) : 1.0);
    fastest = std::max(fastest, factor * inletVelocity(scene, inlet));
  }
  return fastest;
}

double floorHeight(const Scene& scene, double x) {
  return x * std::tan(scene.floor.inclinationDeg * pi / 180.0);
}

double longestStep(const Scene& scene) { return contactTimeScale(scene) / 14.0; }

double packedDragOverErgun(DragLaw law) {
  switch (law) {
    case DragLaw::kochHill:
      return 180.0 / 150.0;
    case DragLaw::beetstra:
      return 1.2111;
    case DragLaw::syamlalOBrien:
      return 1.3643;
    default:
      return 1.0;
  }
}

double packedInertia(const Scene& scene, double density) {
  const VirtualMassSettings* settings = scene.effects.find<VirtualMassSettings>();
  return settings ? density + settings->coefficientAt(packedVoidage) * scene.gas->density : density;
}

double packedRelaxation(const Scene& scene) {
  double least = infinity;  // density times diameter squared
  for (const ParticleKind& kind : particleKinds(scene)) {
    const double d = smallestDiameter(kind);
    least = std::min(least, packedVoidage * packedInertia(scene, kind.density) * d * d);
  }
  return least / (150.0 * (1.0 - packedVoidage) * scene.gas->viscosity) /
         packedDragOverErgun(scene.gas->drag);
}

double longestGasStep(const Scene& scene) {
  return 2.0 * packedVoidage * packedVoidage * packedRelaxation(scene);
}

double tick(const Scene& scene) {
  if (!scene.time.step.isAutomatic()) return scene.time.step;
  if (scene.gas && !scene.gas->step.isAutomatic()) return scene.gas->step;
  if (scene.tickKept) return *scene.tickKept;
  constexpr double parts = 5040.0;  // 2^4 3^2 5 7
  const double coarse = scene.sampling.interval / parts;
  const double halvings = std::ceil(std::log2(coarse / (contactTimeScale(scene) / 100.0)));
  return coarse * std::exp2(-std::max(0.0, halvings));
}

std::int64_t stepsPerFrame(const Scene& scene) { return std::llround(scene.sampling.interval / tick(scene)); }
std::int64_t stepsPerGasStep(const Scene& scene) { return std::llround(scene.gas->step / tick(scene)); }
std::int64_t totalSteps(const Scene& scene) { return std::llround(scene.time.duration / tick(scene)); }

double timeOfStep(const Scene& scene, std::int64_t step) {
  const double length = tick(scene), rate = 1.0 / length;
  const double whole = std::round(rate);
  const bool isWhole = std::abs(rate - whole) < 1e-9 * rate;
  return isWhole ? static_cast<double>(step) / whole : static_cast<double>(step) * length;
}

}  // namespace bedmix
