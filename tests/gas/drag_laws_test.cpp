// SPDX-License-Identifier: MIT
#include "engine/coupling/drag_laws.h"

#include "engine/core/simd.h"
#include "engine/core/power-inl.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace bedmix {
namespace {

constexpr DragProperties air{0.004, 1.205, 1.82e-5};

std::vector<DragLaw> allLaws() {
  std::vector<DragLaw> laws;
  for (const ModelInfo& model : modelTable<DragLaw>) laws.push_back(*findModel<DragLaw>(model.name));
  return laws;
}

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
  for (const DragLaw law : allLaws())
    for (double eps : {0.2, 0.4, 0.6, 0.79, 0.81, 0.999, 1.0}) {
      double slip = 0.0, drag = 0.0;
      evaluateDragLaw(law, air, 1, &eps, &slip, &drag);
      EXPECT_TRUE(std::isfinite(drag)) << modelName(law) << " at " << eps;
      const bool isErgunsAlone = law == DragLaw::ergun && eps == 1.0;
      EXPECT_EQ(drag > 0.0, !isErgunsAlone) << modelName(law) << " at " << eps;
    }
}

TEST(DragLaws, PowersAreThoseOfTheLibraryTo1e14) {
  namespace here = HWY_NAMESPACE;
  const here::hn::CappedTag<double, 1> d;
  const auto power = [&](double x, double exponent) {
    return here::hn::GetLane(here::power(d, here::hn::Set(d, x), exponent));
  };
  const auto raised = [&](double x, double exponent) {
    return here::hn::GetLane(here::power(d, here::hn::Set(d, x), here::hn::Set(d, exponent)));
  };
  double worst = 0.0;
  for (int k = 0; k <= 200'000; ++k) {
    const double voidage = 0.15 + 0.85 * k / 200'000;
    worst = std::max(worst, std::abs(power(voidage, -2.65) / std::pow(voidage, -2.65) - 1.0));
    const double reynolds = std::pow(10.0, -12.0 + 18.0 * k / 200'000);
    worst = std::max(worst, std::abs(power(reynolds, 0.687) / std::pow(reynolds, 0.687) - 1.0));
    const double exponent = -3.0 + 6.0 * (k * 7919 % 200'001) / 200'000;
    worst = std::max(worst, std::abs(raised(reynolds, exponent) / std::pow(reynolds, exponent) - 1.0) / 10);
  }
  EXPECT_LT(worst, 1e-14);
  RecordProperty("worst", fmt::format("{:.2g}", worst));
  EXPECT_EQ(power(0.0, 0.687), 0.0);
  EXPECT_EQ(power(1e-310, 0.687), 0.0);  // no normal number
  EXPECT_EQ(power(1.0, -2.65), 1.0);
  EXPECT_EQ(raised(0.0, 2.5), 0.0);
  EXPECT_LT(raised(1e-299, 2.5), 1e-300);
  EXPECT_GE(raised(1e-299, 2.5), 0.0);
}

TEST(DragLaws, SameBitsAloneAndInVectorsAtEverySimdLevel) {
  std::vector<double> voidage, slip;
  for (int k = 0; k < 1003; ++k) {
    voidage.push_back(0.15 + 0.85 * (k * 377 % 1003) / 1002);
    slip.push_back(15.0 * (k * 131 % 1003) / 1002);
  }
  for (const DragLaw law : allLaws()) {
    std::vector<double> alone(voidage.size()), together(voidage.size());
    for (std::size_t k = 0; k < voidage.size(); ++k)
      evaluateDragLaw(law, air, 1, &voidage[k], &slip[k], &alone[k]);
    for (SimdLevel level : {SimdLevel::baseline, SimdLevel::avx2, SimdLevel::avx512}) {
      if (!useSimdLevel(level)) continue;
      evaluateDragLaw(law, air, voidage.size(), voidage.data(), slip.data(), together.data());
      EXPECT_EQ(together, alone) << modelName(law);
    }
    useSimdLevel(bestSimdLevel());
  }
}

}  // namespace
}  // namespace bedmix
