// SPDX-License-Identifier: MIT
#include "engine/effects/advice.h"

#include "engine/core/gas_grid.h"
#include "engine/core/particle_list.h"
#include "engine/effects/lift_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bedmix {

namespace {

using std::numbers::pi;

constexpr double airDensity = 1.2, airViscosity = 1.8e-5;  // kg/m3, Pa s
// Of contacts between the asperities of dry grains: Hamaker's constant, J; radius and gap, m.
constexpr double dryHamaker = 1e-19, asperity = 1e-7, dryGap = 4e-10;

/// Schiller & Naumann (1933): drag over Stokes's.
double dragFactor(double reynolds) { return 1.0 + 0.15 * std::pow(reynolds, 0.687); }

/// Gas: how long particles take to follow it, over how long they fall through the bed.
EffectAdvice gasAdvice(const Scene& scene) {
  EffectAdvice advice{"gas", "Stokes number", 0.0, scene.gas.has_value(), false, ""};
  const double d = particleMeans(scene).diameter, density = particleMeans(scene).density;
  const double rho = scene.gas ? scene.gas->density : airDensity;
  const double mu = scene.gas ? scene.gas->viscosity : airViscosity;
  const double fall = std::sqrt(2.0 * scene.bed.height / scene.gravity), speed = scene.gravity * fall;
  const double reynolds = rho * speed * d / mu;
  advice.value = density * d * d / (18.0 * mu * dragFactor(reynolds)) / fall;
  advice.matters = advice.value < 10.0;
  advice.meaning = fmt::format(
      "relaxation in {} over the fall through the bed, at Re = {:.3g}; below 10 drag takes a tenth of the "
      "fall's speed and matters (by definition; drag after Schiller & Naumann 1933)",
      scene.gas ? "the gas" : "air", reynolds);
  if (!scene.gas || mostParticles(scene) == 0) return advice;
  const double umf = minimumFluidizationVelocity(scene), fastest = fastestInlet(scene);
  if (!(umf > 0.0)) return advice;
  advice.number = "u/u_mf";
  advice.value = fastest / umf;
  advice.matters = advice.value > 0.1;
  advice.meaning =
      "of the fastest inlet: the share of their weight that the gas bears; matters above 0.1 (Ergun 1952)";
  return advice;
}

EffectAdvice cohesionAdvice(const Scene& scene) {
  EffectAdvice advice{"cohesion", "granular Bond number", 0.0, false, false, ""};
  advice.isOn = scene.effects.find<CohesionSettings>() != nullptr;
  const double weight = particleMass(scene) * scene.gravity;
  const double dry = dryHamaker * asperity / (12.0 * dryGap * dryGap);
  advice.value = (advice.isOn ? pullAtTouch(scene) : dry) / weight;
  advice.matters = advice.value >= 1.0;
  advice.meaning =
      fmt::format("{} over weight; matters above 1 (Seville, Willett & Knight 2000, Powder Technol. 113:261)",
                  advice.isOn ? "pull at touch" : "van der Waals forces between dry asperities of 0.1 um");
  return advice;
}

EffectAdvice rollingAdvice(const Scene& scene) {
  EffectAdvice advice{"contacts.rolling", "mu_r/mu", 0.0, scene.contacts.rolling.has_value(), false, ""};
  if (!advice.isOn) {
    advice.meaning =
        "spheres roll freely; grains that are not round do not (Wensrich & Katterfeld 2012, Powder Technol. "
        "217:409)";
    return advice;
  }
  advice.value = scene.contacts.rolling->coefficient / std::max(scene.contacts.friction->coefficient, 1e-300);
  advice.matters = advice.value > 0.02;
  advice.meaning = "coefficients of rolling and sliding; below 0.02 spheres roll as without (Ai et al. 2011)";
  return advice;
}

/// Saffman's lift over drag, at the fastest inlet's velocity and the strongest shear that a cell may hold.
EffectAdvice liftAdvice(const Scene& scene) {
  const LiftSettings* lift = scene.effects.find<LiftSettings>();
  EffectAdvice advice{"lift", "lift/drag", 0.0, lift != nullptr, false, ""};
  const double d = particleMeans(scene).diameter, slip = fastestInlet(scene), none = 0.0;
  const GasGrid grid = makeGasGrid(scene);
  const double cell = std::min(grid.dx(0), grid.dy(0)), shear = slip / cell;
  const double mu = scene.gas->viscosity, reynolds = scene.gas->density * slip * d / mu;
  double perSlip = 0.0, torque = 0.0;
  const LiftLaw law(*scene.gas, {ShearLift::mei, SpinLift::none});
  law.evaluate({1, &slip, &shear, &none, &d}, &perSlip, &torque);
  advice.value = perSlip / (3.0 * pi * mu * d * dragFactor(reynolds));
  advice.matters = advice.value > 0.1;
  advice.meaning = fmt::format(
      "Saffman's (1965) and Mei's (1992) at the fastest inlet's velocity, Re = {:.3g}, where that changes by "
      "itself over a cell; matters above 0.1 (by definition)",
      reynolds);
  return advice;
}

EffectAdvice virtualMassAdvice(const Scene& scene) {
  const VirtualMassSettings* settings = scene.effects.find<VirtualMassSettings>();
  EffectAdvice advice{"virtual_mass", "C rho/rho_p", 0.0, settings != nullptr, false, ""};
  const double coefficient = (settings ? *settings : VirtualMassSettings()).coefficient;
  advice.value = coefficient * scene.gas->density / particleMeans(scene).density;
  advice.matters = advice.value > 0.05;
  advice.meaning =
      "inertia of the gas that a particle takes along, over its own; matters above 0.05 (by definition; "
      "Auton, Hunt & Prud'homme 1988)";
  return advice;
}

}  // namespace

std::vector<EffectAdvice> effectAdvice(const Scene& scene) {
  std::vector<EffectAdvice> advice;
  if (scene.gravity > 0.0 && mostParticles(scene) > 0) {
    advice.push_back(gasAdvice(scene));
    advice.push_back(cohesionAdvice(scene));
  }
  if (scene.contacts.friction) advice.push_back(rollingAdvice(scene));
  if (scene.gas && mostParticles(scene) > 0) {
    if (fastestInlet(scene) > 0.0) advice.push_back(liftAdvice(scene));
    advice.push_back(virtualMassAdvice(scene));
  }
  return advice;
}

}  // namespace bedmix
