// SPDX-License-Identifier: MIT
#include "app/accuracy/interval.h"
#include "app/accuracy/line_fit.h"
#include "app/accuracy/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace bedmix {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Order, IsThatOfAPower) {
  const std::vector<double> steps{1.0, 2.0, 4.0, 8.0};
  for (const double order : {1.0, 2.0, 4.0}) {
    std::vector<double> errors;
    for (const double s : steps) errors.push_back(1e-5 * std::pow(s, order));
    const auto fit = fitOrder(steps, errors, 0.0, infinity);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->value, order, 1e-12);
    EXPECT_NEAR(fit->uncertainty, 0.0, 1e-12);
    EXPECT_EQ(fit->points, 4);
  }
}

TEST(Order, LeavesOutRoundingAndWhatIsNoLongerSmall) {
  const std::vector<double> steps{0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};
  const std::vector<double> errors{1e-7, 1e-7, 1e-4, 4e-4, 16e-4, 0.9, std::nan("")};
  const auto fit = fitOrder(steps, errors, 1e-6, 0.1);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->value, 2.0, 1e-12);
  EXPECT_EQ(fit->points, 3);
  EXPECT_FALSE(fitOrder(steps, errors, 1e-6, 1e-3));  // two are left
}

// y = 1, 2, 2, 4 over x = 0 to 3: slope 0.9, residuals 0.1, 0.2, -0.7, 0.4, standard error sqrt(0.7/2/5).
TEST(Line, TellsItsUncertainty) {
  const LineFit fit = fitLine(std::vector{0.0, 1.0, 2.0, 3.0}, std::vector{1.0, 2.0, 2.0, 4.0});
  EXPECT_NEAR(fit.slope, 0.9, 1e-12);
  EXPECT_NEAR(fit.intercept, 0.9, 1e-12);
  EXPECT_NEAR(fit.slopeError, std::sqrt(0.7 / 2.0 / 5.0), 1e-12);
}

TEST(Pareto, FrontIsWhatNothingBeats) {
  const std::vector<double> costs{4.0, 1.0, 2.0, 3.0, 2.0, 5.0, 0.5, 1.5};
  const std::vector<double> errors{0.1, 0.8, 0.4, 0.5, 0.6, 0.1, std::nan(""), infinity};
  EXPECT_EQ(paretoFront(costs, errors), (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_TRUE(paretoFront({}, {}).empty());
}

// Tables of Student's t.
TEST(Interval, QuantilesAreStudents) {
  EXPECT_NEAR(studentQuantile(2, 0.05), 4.3027, 1e-3);
  EXPECT_NEAR(studentQuantile(3, 0.05), 3.1824, 1e-3);
  EXPECT_NEAR(studentQuantile(7, 0.05), 2.3646, 1e-3);
  EXPECT_NEAR(studentQuantile(30, 0.05), 2.0423, 1e-3);
  EXPECT_NEAR(studentQuantile(10, 0.01), 3.1693, 1e-3);
  EXPECT_NEAR(studentQuantile(1e5, 0.05), 1.9600, 3e-3);
}

TEST(Interval, OfAMean) {
  const auto found = estimate(std::vector{1.0, 2.0, 3.0, 4.0});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mean, 2.5, 1e-12);
  EXPECT_NEAR(found->halfWidth, 3.1824 * std::sqrt(5.0 / 3.0 / 4.0), 1e-3);
  EXPECT_TRUE(found->differsFromZero());
  EXPECT_FALSE(estimate(std::vector{1.0, 2.0}));
}

// Variances of the means 1/3 and 4/3, degrees (5/3)^2/(1/9/2 + 16/9/2) = 2.941.
TEST(Interval, OfADifferenceOfUnequalSpreads) {
  const auto found = difference(std::vector{9.0, 10.0, 11.0}, std::vector{0.0, 2.0, 4.0});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mean, 8.0, 1e-12);
  EXPECT_NEAR(found->halfWidth, studentQuantile(2.9412, 0.05) * std::sqrt(5.0 / 3.0), 1e-3);
  EXPECT_TRUE(found->differsFromZero());
  EXPECT_FALSE(difference(std::vector{1.0, 2.0, 3.0}, std::vector{1.5, 2.5, 3.0})->differsFromZero());
}

TEST(Spectrum, CentreIsTheFrequencyOfASine) {
  std::vector<double> values;
  for (int i = 0; i < 200; ++i) values.push_back(3.0 + std::sin(2.0 * std::numbers::pi * 5.0 * 0.01 * i));
  EXPECT_NEAR(*spectralCentre(values, 0.01), 5.0, 1e-9);
  EXPECT_FALSE(spectralCentre(std::vector{1.0, 1.0, 1.0}, 0.01));
}

}  // namespace
}  // namespace bedmix
