// SPDX-License-Identifier: MIT
#include "engine/core/index_band.h"

#include "engine/core/rng.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bedmix {
namespace {

/// Half of the particles of equal cells tagged at random.
CellCounts randomMixture(int cells, int perCell, Rng& rng) {
  std::vector<std::uint8_t> tags(static_cast<std::size_t>(cells * perCell));
  for (std::size_t i = 0; i < tags.size(); i += 2) tags[i] = 1;
  for (std::size_t i = tags.size() - 1; i > 0; --i) std::swap(tags[i], tags[rng.next() % (i + 1)]);
  CellCounts counts{std::vector<std::int32_t>(static_cast<std::size_t>(cells), perCell),
                    std::vector<std::int32_t>(static_cast<std::size_t>(cells), 0)};
  for (std::size_t i = 0; i < tags.size(); ++i)
    counts.tracer[i / static_cast<std::size_t>(perCell)] += tags[i];
  return counts;
}

bool holds(const Interval& band, double value) {
  return band.low && *band.low <= value && value <= *band.high;
}

TEST(IndexBand, HoldsTheExpectationOfRandomMixtures) {
  struct Case {
    int cells;
    double coverage;  // what assets/docs/indices.md tells
  };
  for (const Case c : {Case{8, 0.90}, Case{22, 0.93}, Case{60, 0.95}}) {
    constexpr int perCell = 30, mixtures = 1000;
    Rng rng(1);
    const double lacey = 1.0 - 1.0 / ((c.cells * perCell - 1.0) * (perCell - 1.0));
    int held = 0;
    for (int m = 0; m < mixtures; ++m)
      held += holds(mixingBand(randomMixture(c.cells, perCell, rng), 21, static_cast<std::uint64_t>(m)).lacey,
                    lacey);
    const double binomial = std::sqrt(c.coverage * (1 - c.coverage) / mixtures);
    EXPECT_NEAR(held / static_cast<double>(mixtures), c.coverage, 3 * binomial) << c.cells << " cells";
  }
}

TEST(IndexBand, HoldsTheExpectationOfHalfMixedCells) {
  // Fractions of beta(2, 2), whose variance is 1/20; in cells of 30 it is 1/20 + (1/4 - 1/20)/30.
  constexpr int cells = 22, mixtures = 1000;
  Rng rng(2);
  const auto median = [&rng] {  // the second of three uniform ones is beta(2, 2)
    double a = rng.uniform(), b = rng.uniform(), c = rng.uniform();
    return std::max(std::min(a, b), std::min(std::max(a, b), c));
  };
  double expected = 0.0;
  std::vector<MixingBand> bands;
  for (int m = 0; m < mixtures; ++m) {
    CellCounts counts{std::vector<std::int32_t>(cells, 30), std::vector<std::int32_t>(cells, 0)};
    for (std::int32_t& tracer : counts.tracer) {
      const double fraction = median();
      for (int i = 0; i < 30; ++i) tracer += rng.uniform() < fraction;
    }
    expected += *laceyIndex(cellStatistics(counts, 21)) / mixtures;
    bands.push_back(mixingBand(counts, 21, static_cast<std::uint64_t>(m)));
  }
  EXPECT_NEAR(expected, (0.25 - 0.05 - 0.2 / 30) / (0.25 - 0.25 / 30), 0.02);
  int held = 0;
  for (const MixingBand& band : bands) held += holds(band.lacey, expected);
  EXPECT_NEAR(held / static_cast<double>(mixtures), 0.94, 3 * 0.0075);
}

TEST(IndexBand, HoldsTheIndexItselfAndIsTheSameForTheSameSeed) {
  Rng rng(3);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const CellCounts counts = randomMixture(22, 30, rng);
    const CellStatistics cells = cellStatistics(counts, 21);
    const MixingBand band = mixingBand(counts, 21, seed), again = mixingBand(counts, 21, seed);
    EXPECT_TRUE(holds(band.lacey, *laceyIndex(cells)));
    EXPECT_TRUE(holds(band.ashton, *ashtonIndex(cells)));
    EXPECT_EQ(band.lacey.low, again.lacey.low);
    EXPECT_EQ(band.ashton.high, again.ashton.high);
    EXPECT_NE(band.lacey.low, mixingBand(counts, 21, seed + 1).lacey.low);
  }
}

TEST(IndexBand, EndsWhereNothingMoreSegregatedIs) {
  CellCounts counts;
  for (int c = 0; c < 24; ++c) {
    counts.all.push_back(30);
    counts.tracer.push_back(c < 12 ? 30 : 0);
  }
  const MixingBand band = mixingBand(counts, 21, 1);
  EXPECT_NEAR(*band.lacey.low, -(1.0 / 23) / (1 - 1.0 / 30), 1e-12);
  EXPECT_LT(*band.lacey.high, 0.3);
}

TEST(IndexBand, FewCellsOrNoVarianceHaveNone) {
  Rng rng(4);
  EXPECT_FALSE(mixingBand(randomMixture(7, 30, rng), 21, 1).lacey.low);
  EXPECT_FALSE(mixingBand({}, 21, 1).lacey.low);
  EXPECT_FALSE(
      mixingBand({std::vector<std::int32_t>(20, 30), std::vector<std::int32_t>(20, 15)}, 21, 1).lacey.low);
}

}  // namespace
}  // namespace bedmix
