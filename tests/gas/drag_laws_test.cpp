// SPDX-License-Identifier: MIT
#include "engine/coupling/drag_laws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

constexpr DragProperties air{0.004, 1.205, 1.82e-5};

/// beta of one particle, kg/(m3 s).
double beta(DragLaw law, double voidage, double slip) {
  double drag = 0.0;
  evaluateDragLaw(law, air, 1, &voidage, &slip, &drag);
  return (1.0 - voidage) * drag;
}

TEST(DragLaws, ErgunGivesBackTheFixedBedEquation) {
  // dp/dy = beta u / eps with u = U / eps must be Ergun's 150 (1-e)^2 mu U/(e^3 d^2) + 1.75 (1-e) rho
  // U^2/(e^3 d).
  const double eps = 0.44, superficial = 1.3, d = air.diameter;
  const double slip = superficial / eps;
  const double gradient = beta(DragLaw::ergun, eps, slip) * slip / eps;
  const double ergun = 150 * (1 - eps) * (1 - eps) * air.viscosity * superficial / (eps * eps * eps * d * d) +
                       1.75 * (1 - eps) * air.gasDensity * superficial * superficial / (eps * eps * eps * d);
  EXPECT_NEAR(gradient / ergun, 1.0, 1e-14);
}

TEST(DragLaws, WenYuIsStokesDragOfASingleSphereWhenSlowAndDilute) {
  // Force on one sphere: V_p beta / (1 - eps) * slip -> 3 pi mu d slip.
  const double slip = 1e-9, eps = 1.0 - 1e-9, d = air.diameter;
  const double volume = std::numbers::pi / 6 * d * d * d;
  const double force = volume * beta(DragLaw::wenYu, eps, slip) / (1 - eps) * slip;
  EXPECT_NEAR(force / (3 * std::numbers::pi * air.viscosity * d * slip), 1.0, 1e-5);
}

TEST(DragLaws, TerminalSlipOfThePapersSphereIs12Point31) {
  // paper.md: 12.31 m/s at voidage 1; there Re > 1000 and C_D = 0.43.
  const double eps = 1.0 - 1e-9, d = air.diameter, slip = 12.31;
  const double perVolume = beta(DragLaw::wenYu, eps, slip) / (1 - eps) * slip;
  EXPECT_NEAR(perVolume / ((1500.0 - air.gasDensity) * 9.81), 1.0, 2e-3);
  EXPECT_GT(air.gasDensity * d * slip / air.viscosity, 1000.0);
}

TEST(DragLaws, SwitchAtVoidagePointEight) {
  EXPECT_EQ(beta(DragLaw::ergunWenYu, 0.8, 2.0), beta(DragLaw::ergun, 0.8, 2.0));
  EXPECT_EQ(beta(DragLaw::ergunWenYu, 0.8001, 2.0), beta(DragLaw::wenYu, 0.8001, 2.0));
  EXPECT_NEAR(beta(DragLaw::ergunWenYuPrinted, 0.9, 2.0) * 0.9, beta(DragLaw::wenYu, 0.9, 2.0), 1e-12);
}

TEST(DragLaws, FiniteAtZeroSlip) {
  for (DragLaw law : {DragLaw::ergunWenYu, DragLaw::ergunWenYuPrinted, DragLaw::ergun, DragLaw::wenYu})
    for (double eps : {0.4, 0.79, 0.81, 0.999}) {
      EXPECT_TRUE(std::isfinite(beta(law, eps, 0.0)));
      EXPECT_GT(beta(law, eps, 0.0), 0.0);
    }
}

}  // namespace
}  // namespace bedmix
