// SPDX-License-Identifier: MIT
#include "replay/analysis/throughput.h"

#include "tests/replay/analysis_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace bedmix::test {
namespace {

constexpr double interval = 0.01;  // s

Scene fedScene(std::int64_t atStart) {
  Scene scene = syntheticScene(false, false);
  scene.particles.count = atStart;
  scene.effects.at<FeedSettings>().emplace().most = 10000;
  return scene;
}

Frame frameWith(int index, const std::set<std::int32_t>& there) {
  Frame frame;
  frame.time = interval * index;
  for (const std::int32_t id : there) {
    frame.id.push_back(id);
    frame.position.push_back({0.01f, 0.01f});
    frame.velocity.push_back({});
    frame.species.push_back(0);
  }
  return frame;
}

/// One comes in each frame and leaves after so many as `stay` says of it.
template <class Stay>
void flow(Throughput& analysis, int atStart, int frames, const Stay& stay) {
  std::set<std::int32_t> there;
  std::multimap<int, std::int32_t> leaves;
  for (int id = 0; id < atStart; ++id) {
    there.insert(id);
    leaves.emplace(1 + id, id);
  }
  std::int32_t next = atStart;
  for (int i = 0; i < frames; ++i) {
    for (auto [at, end] = leaves.equal_range(i); at != end; ++at) there.erase(at->second);
    if (i > 0) {
      there.insert(next);
      leaves.emplace(i + stay(next), next);
      ++next;
    }
    analysis.accept(frameWith(i, there));
  }
}

TEST(Throughput, OfAPipeIsOneTime) {
  const Scene scene = fedScene(5);
  Throughput analysis({scene, 200, interval});
  flow(analysis, 5, 200, [](int) { return 20; });
  EXPECT_NEAR(found(analysis, "residence_mean"), 0.2, 1e-12);
  EXPECT_NEAR(found(analysis, "residence_variance"), 0.0, 1e-9);
  EXPECT_NEAR(found(analysis, "particles_entered"), 100.0, 1e-9);
  EXPECT_NEAR(found(analysis, "particles_left"), (5 + 179) / 1.99, 1e-9);
  const Table table = tableOf(analysis, "residence_times");
  ASSERT_EQ(table.rows(), 100u);
  EXPECT_EQ(at(table, "share", 98), 0.0);
  EXPECT_EQ(at(table, "share", 99), 1.0);
  EXPECT_EQ(at(table, "left", 99), 179.0);
}

/// Of exponential stays F is that of a stirred tank, although the run ends after two of its means and most
/// are cut off: their plain mean would be far too short.
TEST(Throughput, OfAStirredTankIsExponential) {
  const Scene scene = fedScene(0);
  constexpr double tau = 400.0;  // frames
  constexpr int frames = 8000, ofShort = 800;
  Rng rng(7);
  const auto stay = [&](int) { return 1 + static_cast<int>(-tau * std::log(1.0 - rng.uniform())); };
  Throughput whole({scene, frames, interval});
  flow(whole, 0, frames, stay);
  EXPECT_NEAR(found(whole, "residence_mean"), tau * interval, 0.05 * tau * interval);
  EXPECT_NEAR(found(whole, "stirred_tanks"), 1.0, 0.1);
  const Table table = tableOf(whole, "residence_times");
  const double bound = 1.63 / std::sqrt(frames - 5.0 * tau);  // Kolmogorov, 1 %
  for (std::size_t row = 0; row < table.rows(); ++row)
    EXPECT_NEAR(at(table, "share", row), 1.0 - std::exp(-at(table, "time", row) / (tau * interval)), bound);

  Throughput cut({scene, ofShort, interval});
  flow(cut, 0, ofShort, stay);
  const Table early = tableOf(cut, "residence_times");
  double sum = 0.0, left = 0.0;
  for (std::size_t row = 0; row < early.rows(); ++row) {
    left += at(early, "left", row);
    sum += at(early, "left", row) * at(early, "time", row);
    EXPECT_NEAR(at(early, "share", row), 1.0 - std::exp(-at(early, "time", row) / (tau * interval)), 0.1);
  }
  EXPECT_LT(sum / left, 0.8 * tau * interval);
}

/// In a steady state the mean stay is those there over those who leave (Danckwerts 1953).
TEST(Throughput, MeanIsHoldUpOverOutflow) {
  const Scene scene = fedScene(0);
  Throughput analysis({scene, 6000, interval});
  flow(analysis, 0, 6000, [](int id) { return id % 3 == 0 ? 10 : 40; });
  EXPECT_NEAR(found(analysis, "residence_mean"), 0.3, 1e-3);
  EXPECT_NEAR(found(analysis, "hold_up_over_outflow"), 0.3, 2e-3);
  EXPECT_NEAR(found(analysis, "hold_up"), 30.0, 0.3);
}

TEST(Throughput, CountsWhoCameAndLeftBetweenTwoFrames) {
  const Scene scene = fedScene(2);
  Throughput analysis({scene, 3, interval});
  analysis.accept(frameWith(0, {0, 1}));
  analysis.accept(frameWith(1, {0, 1, 5}));  // 2 to 4 have come and gone
  analysis.accept(frameWith(2, {1, 5}));
  EXPECT_NEAR(found(analysis, "particles_entered"), 4.0 / 0.02, 1e-9);
  EXPECT_NEAR(found(analysis, "particles_left"), 4.0 / 0.02, 1e-9);
}

TEST(Throughput, OfNobodyIsUndefined) {
  const Scene scene = fedScene(0);
  Throughput analysis({scene, 1, interval});
  analysis.accept(frameWith(0, {}));
  EXPECT_TRUE(std::isnan(found(analysis, "residence_mean")));
  EXPECT_TRUE(std::isnan(found(analysis, "particles_left")));
  EXPECT_EQ(tableOf(analysis, "residence_times").rows(), 0u);
}

}  // namespace
}  // namespace bedmix::test
