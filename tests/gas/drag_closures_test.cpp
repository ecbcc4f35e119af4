// SPDX-License-Identifier: MIT
#include "engine/core/scene.h"
#include "engine/coupling/drag_laws.h"
#include "tests/gas/gas_scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace bedmix {
namespace {

using std::numbers::pi;

constexpr DragProperties fluid{0.004, 1.205, 1.82e-5};
const std::vector<DragLaw> closures{DragLaw::gidaspow, DragLaw::diFelice, DragLaw::kochHill,
                                    DragLaw::beetstra, DragLaw::syamlalOBrien};

/// Force on one particle, N.
double force(DragLaw law, double voidage, double slip) {
  double drag = 0.0;
  evaluateDragLaw(law, fluid, 1, &voidage, &slip, &drag);
  return pi / 6 * std::pow(fluid.diameter, 3) * drag * slip;
}

/// Slip, m/s, at a Reynolds number of the superficial velocity.
double slipAt(double reynolds, double voidage) {
  return reynolds * fluid.viscosity / (fluid.gasDensity * fluid.diameter * voidage);
}

/// F of the literature: force over Stokes's in the superficial velocity.
double relativeForce(DragLaw law, double voidage, double reynolds) {
  const double slip = slipAt(reynolds, voidage);
  return force(law, voidage, slip) / (3 * pi * fluid.viscosity * fluid.diameter * voidage * slip);
}

/// The same as each paper prints it, e voidage, p = 1 - e, R superficial.
double printed(DragLaw law, double e, double R) {
  const double p = 1 - e;
  if (law == DragLaw::gidaspow) {
    const double cd = R < 1000 ? 24 / R * (1 + 0.15 * std::pow(R, 0.687)) : 0.44;
    const double ergun = (150 * p + 1.75 * R) / (18 * e * e);
    const double share = std::atan(150 * 1.75 * (0.2 - p)) / pi + 0.5;
    return (1 - share) * ergun + share * cd * R / 24 * std::pow(e, -3.65);
  }
  if (law == DragLaw::diFelice) {
    const double cd = std::pow(0.63 + 4.8 / std::sqrt(R), 2);
    const double chi = 3.7 - 0.65 * std::exp(-std::pow(1.5 - std::log10(R), 2) / 2);
    return cd * R / 24 * std::pow(e, -chi);
  }
  if (law == DragLaw::kochHill) {
    const double f0 = p < 0.4 ? (1 + 3 * std::sqrt(p / 2) + 135.0 / 64 * p * std::log(p) + 16.14 * p) /
                                    (1 + 0.681 * p - 8.48 * p * p + 8.16 * p * p * p)
                              : 10 * p / std::pow(e, 3);
    const double f3 = 0.0673 + 0.212 * p + 0.0232 / std::pow(e, 5);
    return e * (f0 + f3 * R / 2);
  }
  if (law == DragLaw::beetstra)
    return 10 * p / (e * e) + e * e * (1 + 1.5 * std::sqrt(p)) +
           0.413 * R / (24 * e * e) * (1 / e + 3 * p * e + 8.4 * std::pow(R, -0.343)) /
               (1 + std::pow(10, 3 * p) * std::pow(R, -(1 + 4 * p) / 2));
  const double r = R / e, a = std::pow(e, 4.14);  // Syamlal & O'Brien
  const double b = e <= 0.85 ? 0.8 * std::pow(e, 1.28) : std::pow(e, 2.65);
  const long double x = 0.06L * r;
  const auto v = static_cast<double>((a - x + std::sqrt(x * x + 2 * x * (2 * b - a) + a * a)) / 2);
  const double cd = std::pow(0.63 + 4.8 * std::sqrt(v / r), 2);
  return 3.0 / 4 * cd * r / (v * v) / 18;
}

TEST(DragClosures, AreThosePrinted) {
  for (const DragLaw law : closures)
    for (const double voidage :
         {0.35, 0.4, 0.45, 0.55, 0.61, 0.7, 0.799, 0.8, 0.805, 0.84, 0.86, 0.95, 0.999})
      for (const double reynolds : {1e-6, 0.1, 1.0, 10.0, 100.0, 900.0, 1500.0, 8000.0})
        EXPECT_NEAR(relativeForce(law, voidage, reynolds) / printed(law, voidage, reynolds), 1.0, 1e-12)
            << modelName(law) << " at voidage " << voidage << ", Re " << reynolds;
}

TEST(DragClosures, OfDenseSlowArraysAreCarmansWithin2Percent) {
  // Lattice Boltzmann simulations of dense random arrays gave back Carman's (1937) 180, not Ergun's 150.
  for (const double voidage : {0.4, 0.5}) {
    const double carman = 10 * (1 - voidage) / (voidage * voidage);
    EXPECT_NEAR(relativeForce(DragLaw::kochHill, voidage, 1e-9) / carman, 1.0, 1e-6);
    EXPECT_NEAR(relativeForce(DragLaw::beetstra, voidage, 1e-9) / carman, 1.0, 0.03);
  }
}

TEST(DragClosures, TendToTheirSingleSphere) {
  const double alone = 1.0;
  for (const double reynolds : {1e-6, 1.0, 50.0, 500.0, 5000.0}) {
    const double dallavalle = std::pow(0.63 * std::sqrt(reynolds) + 4.8, 2) / 24;
    const double wenYu = reynolds < 1000 ? 1 + 0.15 * std::pow(reynolds, 0.687) : 0.44 * reynolds / 24;
    const double share = std::atan(52.5) / pi + 0.5, ergun = 1.75 * reynolds / 18;
    EXPECT_NEAR(relativeForce(DragLaw::diFelice, alone, reynolds) / dallavalle, 1.0, 1e-12);
    EXPECT_NEAR(relativeForce(DragLaw::syamlalOBrien, alone, reynolds) / dallavalle, 1.0, 1e-12);
    EXPECT_NEAR(relativeForce(DragLaw::gidaspow, alone, reynolds) / (share * wenYu + (1 - share) * ergun),
                1.0, 1e-12);
    EXPECT_NEAR(relativeForce(DragLaw::kochHill, alone, reynolds) / (1 + 0.04525 * reynolds), 1.0, 1e-12);
    // No law of spheres in a suspension is far from that of Schiller and Naumann where both are made for.
    if (reynolds > 100) continue;
    for (const DragLaw law : closures)
      EXPECT_NEAR(relativeForce(law, alone, reynolds) / wenYu, 1.0, 0.2) << modelName(law);
  }
  // Stokes's, of those that have it.
  for (const DragLaw law : {DragLaw::kochHill, DragLaw::beetstra})
    EXPECT_NEAR(relativeForce(law, alone, 1e-12), 1.0, 1e-6) << modelName(law);
}

/// Slip, m/s, at which the drag is `share` of the weight of a particle that is heavier by `excess`, kg/m3.
double settling(DragLaw law, double voidage, double excess) {
  const double wanted = voidage * excess * 9.81 * pi / 6 * std::pow(fluid.diameter, 3);
  double low = 0.0, high = 1e3;
  for (int k = 0; k < 200; ++k)
    (force(law, voidage, (low + high) / 2) < wanted ? low : high) = (low + high) / 2;
  return low;
}

TEST(DragClosures, SyamlalAndOBriensSuspensionSettlesAsGarsideAndAlDibounis) {
  // (V - A) / (B - V) = 0.06 Re, of the sphere alone: Garside & Al-Dibouni (1977).
  for (const double excess : {1e-4, 1.0, 1500.0})
    for (const double voidage : {0.5, 0.7, 0.9}) {
      const double alone = settling(DragLaw::syamlalOBrien, 1.0, excess);
      const double slip = settling(DragLaw::syamlalOBrien, voidage, excess), v = slip / alone;
      const double reynolds = fluid.gasDensity * alone * fluid.diameter / fluid.viscosity;
      const double a = std::pow(voidage, 4.14);
      const double b = voidage <= 0.85 ? 0.8 * std::pow(voidage, 1.28) : std::pow(voidage, 2.65);
      EXPECT_NEAR((v - a) / (b - v) / (0.06 * reynolds), 1.0, 1e-8) << excess << " at " << voidage;
    }
}

TEST(DragClosures, DiFelicesSlowSuspensionSettlesByRichardsonAndZaki) {
  // U = u_t eps^n; 4.7 of a slow one, 4.65 of theirs (1954).
  const double alone = settling(DragLaw::diFelice, 1.0, 1e-9), voidage = 0.7;
  const double n = std::log(voidage * settling(DragLaw::diFelice, voidage, 1e-9) / alone) / std::log(voidage);
  EXPECT_NEAR(n, 4.7, 0.01);
}

TEST(DragClosures, GrowWithSlipAndWithSolids) {
  for (const DragLaw law : closures)
    for (int k = 0; k < 60; ++k) {
      const double voidage = 0.36 + 0.63 * k / 60;
      double before = 0.0;
      for (double reynolds = 1e-3; reynolds < 999.0; reynolds *= 1.1) {
        const double f = force(law, voidage, slipAt(reynolds, voidage));
        EXPECT_GT(f, before) << modelName(law) << " at voidage " << voidage << ", Re " << reynolds;
        before = f;
      }
      if (k > 0 && law != DragLaw::gidaspow && law != DragLaw::kochHill) {
        const double slip = slipAt(100.0, voidage);
        EXPECT_LT(force(law, voidage, slip), force(law, voidage - 0.63 / 60, slip)) << modelName(law);
      }
    }
}

TEST(DragClosures, AreContinuousWhereTheyClaimIt) {
  const auto jump = [](DragLaw law, double voidage, double reynolds) {
    return relativeForce(law, voidage + 1e-9, reynolds) / relativeForce(law, voidage - 1e-9, reynolds) - 1.0;
  };
  for (const double reynolds : {0.1, 30.0, 700.0}) {
    EXPECT_NEAR(jump(DragLaw::gidaspow, 0.8, reynolds), 0.0, 1e-5);  // Ergun's to Wen & Yu's is 18 % at Re 30
    EXPECT_NEAR(jump(DragLaw::kochHill, 0.6, reynolds), 0.0, 0.02);
    EXPECT_NEAR(jump(DragLaw::syamlalOBrien, 0.85, reynolds), 0.0, 0.005);
  }
  EXPECT_GT(std::abs(jump(DragLaw::ergunWenYu, 0.8, 30.0)), 0.1);
}

/// Superficial velocity, m/s, at which drag and pressure carry the paper's particles at voidage 0.4.
double minimumFluidization(DragLaw law) {
  return packedVoidage * settling(law, packedVoidage, 1500.0 - fluid.gasDensity);
}

TEST(DragClosures, FluidizeThePapersParticlesAtTheVelocitiesOfTheDocumentation) {
  const std::vector<std::pair<DragLaw, double>> documented{
      {DragLaw::ergunWenYu, 1.242},   {DragLaw::wenYu, 1.165},    {DragLaw::gidaspow, 1.242},
      {DragLaw::diFelice, 1.251},     {DragLaw::kochHill, 1.348}, {DragLaw::beetstra, 1.382},
      {DragLaw::syamlalOBrien, 1.107}};
  for (const auto& [law, velocity] : documented)
    EXPECT_NEAR(minimumFluidization(law), velocity, 0.0005) << modelName(law);
}

TEST(DragClosures, PackedBedFollowsTheGasNoFasterThanTheSceneCounts) {
  Scene scene = test::paperScene(1.0);
  scene.particles.diameter = fluid.diameter;
  scene.gas->density = fluid.gasDensity;
  scene.gas->viscosity = fluid.viscosity;
  for (const ModelInfo& model : modelTable<DragLaw>) {
    scene.gas->drag = *findModel<DragLaw>(model.name);
    const double voidage = packedVoidage, slip = 0.0;
    double drag = 0.0;
    evaluateDragLaw(scene.gas->drag, fluid, 1, &voidage, &slip, &drag);
    const double relaxation = scene.particles.density / drag;
    EXPECT_GE(relaxation / packedRelaxation(scene), 1.0 - 1e-12) << model.name;
    EXPECT_LT(relaxation / packedRelaxation(scene), 1.11) << model.name;
  }
}

}  // namespace
}  // namespace bedmix
