// SPDX-License-Identifier: MIT
#include "engine/effects/cohesion.h"

#include "engine/core/particle_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bedmix {

using std::numbers::pi;

namespace {

/// Gaps are no wider than this, of the smallest diameter, or lists of neighbours would hold all.
constexpr double widest = 1.0;

double angle(const LiquidBridgeSettings& liquid) { return liquid.contactAngleDeg * pi / 180.0; }

}  // namespace

BridgeLaw pairBridge(const LiquidBridgeSettings& liquid) {
  const double v = liquid.volume, logV = std::log(v), theta = angle(liquid);
  return {-1.1 * std::pow(v, -0.53), (-0.034 * logV - 0.96) * theta * theta - 0.019 * logV + 0.48,
          0.0042 * logV + 0.078, (0.62 * theta + 0.99) * std::pow(v, 0.34)};
}

BridgeLaw wallBridge(const LiquidBridgeSettings& liquid) {
  const double v = liquid.volume, logV = std::log(v), theta = angle(liquid);
  return {-1.9 * std::pow(v, -0.51), (-0.016 * logV - 0.76) * theta * theta - 0.12 * logV + 1.2,
          0.013 * logV + 0.18, (0.22 * theta + 0.95) * std::pow(v, 0.32)};
}

double cohesionRange(const Scene& scene) {
  const CohesionSettings* cohesion = scene.effects.find<CohesionSettings>();
  if (!cohesion) return 0.0;
  if (cohesion->vanDerWaals) return cohesion->vanDerWaals->cutoff;
  if (!cohesion->liquidBridge) return 0.0;
  return 0.5 * particleRange(scene).largest *
         std::max(pairBridge(*cohesion->liquidBridge).rupture, wallBridge(*cohesion->liquidBridge).rupture);
}

double pullAtTouch(const Scene& scene) {
  const CohesionSettings* cohesion = scene.effects.find<CohesionSettings>();
  if (!cohesion) return 0.0;
  const double r = 0.5 * scene.particles.diameter;
  if (const auto& force = cohesion->vanDerWaals)
    return force->hamaker * 0.5 * r / (6.0 * force->leastGap * force->leastGap);
  if (const auto& liquid = cohesion->liquidBridge) {
    const BridgeLaw law = pairBridge(*liquid);
    return pi * r * liquid->surfaceTension * (std::exp(law.b) + law.c);
  }
  // It grows with the overlap: that at which the spring bears the particle's weight.
  const double overlap = particleMass(scene) * scene.gravity / normalStiffness(scene);
  return cohesion->sjkr->energyDensity * pi * r * overlap;
}

std::vector<Contradiction> contradictions(const Scene& scene, const CohesionSettings& cohesion) {
  std::vector<Contradiction> broken;
  const int laws =
      cohesion.vanDerWaals.has_value() + cohesion.liquidBridge.has_value() + cohesion.sjkr.has_value();
  if (laws != 1)
    return {{"cohesion",
             fmt::format("there are {} laws of attraction in [cohesion]; give one of the tables "
                         "[cohesion.van_der_waals], [cohesion.liquid_bridge], [cohesion.sjkr]",
                         laws),
             {}}};
  const double range = cohesionRange(scene), most = widest * particleRange(scene).smallest;
  if (range > most)
    broken.push_back(
        {cohesion.vanDerWaals ? "cohesion.van_der_waals.cutoff" : "cohesion.liquid_bridge.volume",
         fmt::format("the attraction reaches over gaps of {:.3g} m, further than the smallest "
                     "particle is wide ({:.3g} m)",
                     range, most),
         {"particles.diameter"}});
  if (cohesion.vanDerWaals && cohesion.vanDerWaals->leastGap > cohesion.vanDerWaals->cutoff)
    broken.push_back({"cohesion.van_der_waals.least_gap",
                      "the least gap is beyond the cutoff, so that there is no attraction",
                      {"cohesion.van_der_waals.cutoff"}});
  if (cohesion.liquidBridge && scene.time.integrator == Integrator::rk4)
    broken.push_back({"cohesion.liquid_bridge",
                      "whether there is a bridge is not among what time.integrator = \"rk4\" advances; take "
                      "another integrator",
                      {"time.integrator"}});
  return broken;
}

}  // namespace bedmix
