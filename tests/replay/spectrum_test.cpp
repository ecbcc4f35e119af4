// SPDX-License-Identifier: MIT
#include "replay/analysis/spectrum.h"

#include "tests/replay/analysis_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix::test {
namespace {

double integral(const Table& table, std::string_view column) {
  double sum = 0.0;
  for (std::size_t r = 0; r < table.rows(); ++r) sum += at(table, column, r) * at(table, "frequency", 0);
  return sum;
}

TEST(Spectrum, OfWavesHasTheirFrequenciesAndVariances) {
  // 768 frames make segments of 256, 2.56 s: 8 and 20 waves fit.
  const Scene scene = syntheticScene(true, false);
  Spectrum analysis({scene, 768, 0.01});
  for (int i = 0; i < 768; ++i) {
    const double phase = 2.0 * std::numbers::pi * i / 256.0;
    Frame frame = frameOf(0.01 * i, std::vector<Vec2>(50, {0.02, 0.05 + 0.01 * std::sin(8.0 * phase)}));
    frame.gas.pressure.assign(40, static_cast<float>(1000.0 + 200.0 * std::cos(20.0 * phase)));
    frame.gas.voidage.assign(40, 0.5f);
    frame.gas.velocity.assign(40, {});
    analysis.accept(frame);
  }
  EXPECT_NEAR(found(analysis, "height_frequency"), 8.0 / 2.56, 1e-9);
  EXPECT_NEAR(found(analysis, "pressure_frequency"), 20.0 / 2.56, 1e-9);
  EXPECT_NEAR(found(analysis, "pressure_deviation"), 200.0 / std::sqrt(2.0), 0.2);
  const Table table = tableOf(analysis, "spectrum");
  ASSERT_EQ(table.rows(), 128u);
  EXPECT_NEAR(at(table, "frequency", 127), 50.0, 1e-9);
  EXPECT_NEAR(integral(table, "bed_height"), 0.01 * 0.01 / 2.0, 1e-9);
  EXPECT_NEAR(integral(table, "pressure_drop"), 200.0 * 200.0 / 2.0, 0.1);
}

TEST(Spectrum, OfNoiseIsFlatAndAddsUpToTheVariance) {
  const Scene scene = syntheticScene(false, false);
  Rng rng(3);
  Spectrum analysis({scene, 6144, 0.01});
  for (int i = 0; i < 6144; ++i) analysis.accept(frameOf(0.01 * i, {{0.02, rng.uniform(0.0, 0.1)}}));
  const Table table = tableOf(analysis, "spectrum");
  EXPECT_NEAR(integral(table, "bed_height") / (0.1 * 0.1 / 12.0), 1.0, 0.05);
  EXPECT_TRUE(std::isnan(at(table, "pressure_drop", 0)));
}

TEST(Spectrum, NeedsAFewFrames) {
  const Scene scene = syntheticScene(true, false);
  Spectrum analysis({scene, 3, 0.01});
  for (int i = 0; i < 3; ++i) analysis.accept(syntheticFrame(scene, i));
  EXPECT_EQ(tableOf(analysis, "spectrum").rows(), 0u);
  EXPECT_TRUE(std::isnan(found(analysis, "pressure_frequency")));
}

}  // namespace
}  // namespace bedmix::test
