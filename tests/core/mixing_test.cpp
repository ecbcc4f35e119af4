// SPDX-License-Identifier: MIT
#include "engine/core/mixing.h"

#include "engine/core/rng.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace bedmix {
namespace {

MixingSample sampleOf(const CellCounts& counts, int minParticles = 1) {
  std::size_t particles = 0;
  for (std::int32_t n : counts.all) particles += static_cast<std::size_t>(n);
  return mixingSample(cellStatistics(counts, minParticles), 0.0, particles);
}

/// A bed of 4 x 15 unit cells, unevenly filled, its positions exact and never on an edge between cells.
Frame unevenBed(std::uint64_t seed) {
  Rng rng(seed);
  Frame frame;
  for (int i = 0; i < 1500; ++i) {
    const auto on = [&rng](double length) {
      return static_cast<float>(std::floor(rng.uniform(0.0, length) * 1024) / 1024 + 1.0 / 2048);
    };
    const float x = on(4.0), y = on(rng.uniform() < 0.7 ? 8.0 : 15.0);
    frame.position.push_back({x, y});
    frame.species.push_back(rng.uniform() < 0.2 + 0.15 * x);
  }
  return frame;
}
constexpr SamplingGrid unitCells{4, 15, 21, 4.0, 15.0};

TEST(Mixing, SegregatedBedHasItsClosedForm) {
  CellCounts counts;
  for (int c = 0; c < 60; ++c) {
    counts.all.push_back(25);
    counts.tracer.push_back(c < 30 ? 25 : 0);
  }
  const MixingSample s = sampleOf(counts);
  EXPECT_NEAR(*s.lacey, -(1.0 / 59) / (1 - 1.0 / 25), 1e-14);
  EXPECT_NEAR(*s.lacey, -0.0177, 5e-5);
  EXPECT_NEAR(*s.ashton, std::log(59.0 / 60) / std::log(25.0), 1e-14);
  EXPECT_NEAR(*s.stddev, std::sqrt(60 * 0.25 / 59), 1e-14);
  EXPECT_EQ(*s.tracerMean, 0.5);
  EXPECT_EQ(*s.particlesPerCell, 25.0);
  EXPECT_EQ(s.cells, 60);
  EXPECT_EQ(s.countedFraction, 1.0);
}

TEST(Mixing, MeanOverAllWaysToTagIsExact) {
  // 6 of 12 particles in 4 cells of 3: the mean Lacey index over all 924 ways is 1 - 1/((T-1)(n-1)).
  double sum = 0.0;
  int ways = 0;
  for (unsigned tags = 0; tags < 1u << 12; ++tags) {
    if (std::popcount(tags) != 6) continue;
    CellCounts counts{{3, 3, 3, 3}, {}};
    for (int c = 0; c < 4; ++c) counts.tracer.push_back(std::popcount((tags >> 3 * c) & 7u));
    sum += *sampleOf(counts).lacey;
    ++ways;
  }
  EXPECT_EQ(ways, 924);
  EXPECT_NEAR(sum / ways, 1.0 - 1.0 / (11.0 * 2.0), 1e-13);
}

TEST(Mixing, RandomTagsScatterAroundOne) {
  Rng rng(20);
  std::vector<int> tags(1500);
  std::fill(tags.begin(), tags.begin() + 750, 1);
  constexpr int draws = 4000;
  double sum = 0.0, squares = 0.0;
  for (int d = 0; d < draws; ++d) {
    for (std::size_t i = tags.size() - 1; i > 0; --i) std::swap(tags[i], tags[rng.next() % (i + 1)]);
    CellCounts counts{std::vector<std::int32_t>(60, 25), std::vector<std::int32_t>(60, 0)};
    for (std::size_t i = 0; i < tags.size(); ++i) counts.tracer[i / 25] += tags[i];
    const double lacey = *sampleOf(counts).lacey;
    sum += lacey, squares += lacey * lacey;
  }
  const double mean = sum / draws;
  const double standardError = std::sqrt((squares / draws - mean * mean) / draws);
  EXPECT_LT(standardError, 2e-4);
  EXPECT_NEAR(mean, 1.0 - 1.0 / (1499.0 * 24.0), 4 * standardError);
}

TEST(Mixing, WithoutVarianceAshtonIsUndefined) {
  const MixingSample s = sampleOf({std::vector<std::int32_t>(60, 24), std::vector<std::int32_t>(60, 12)});
  EXPECT_EQ(*s.stddev, 0.0);
  EXPECT_NEAR(*s.lacey, 1.0 / (1.0 - 1.0 / 24), 1e-14);
  EXPECT_FALSE(s.ashton);
}

TEST(Mixing, WhatIsNotDefinedIsEmpty) {
  const MixingSample oneSpecies = sampleOf({{30, 30, 30}, {0, 0, 0}});
  EXPECT_EQ(*oneSpecies.stddev, 0.0);
  EXPECT_FALSE(oneSpecies.lacey);
  EXPECT_FALSE(oneSpecies.ashton);

  const MixingSample oneCell = sampleOf({{30, 2, 2}, {10, 1, 1}}, 21);
  EXPECT_EQ(oneCell.cells, 1);
  EXPECT_NEAR(*oneCell.tracerMean, 1.0 / 3, 1e-15);
  EXPECT_FALSE(oneCell.stddev);
  EXPECT_FALSE(oneCell.lacey);

  const MixingSample noCell = sampleOf({{2, 2}, {1, 1}}, 21);
  EXPECT_EQ(noCell.cells, 0);
  EXPECT_EQ(noCell.countedFraction, 0.0);
  EXPECT_FALSE(noCell.tracerMean);
  EXPECT_FALSE(noCell.particlesPerCell);

  const MixingSample onePerCell = sampleOf({{1, 1, 1}, {1, 0, 1}});
  EXPECT_TRUE(onePerCell.stddev);
  EXPECT_FALSE(onePerCell.lacey);

  EXPECT_EQ(mixingSample(Frame{}, unitCells).countedFraction, 0.0);
}

TEST(Mixing, CellsWithFewerParticlesAreLeftOut) {
  const MixingSample s = sampleOf({{21, 20, 40}, {7, 20, 10}}, 21);
  EXPECT_EQ(s.cells, 2);
  EXPECT_NEAR(*s.tracerMean, (7.0 / 21 + 10.0 / 40) / 2, 1e-15);
  EXPECT_EQ(*s.particlesPerCell, 30.5);
  EXPECT_NEAR(s.countedFraction, 61.0 / 81, 1e-15);
}

TEST(Mixing, FollowsTheEquationsAsPrinted) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Frame frame = unevenBed(seed);
    // Tian et al. (2007), Eqs (13) to (15), cell by cell.
    std::vector<double> c, n;
    for (float row = 0; row < 15; ++row) {
      for (float column = 0; column < 4; ++column) {
        double all = 0, tracer = 0;
        for (std::size_t i = 0; i < frame.size(); ++i) {
          const Vec2f p = frame.position[i];
          if (p.x > column && p.x < column + 1 && p.y > row && p.y < row + 1)
            ++all, tracer += frame.species[i];
        }
        if (all > 20) c.push_back(tracer / all), n.push_back(all);
      }
    }
    const double cells = static_cast<double>(c.size());
    double mean = 0, perCell = 0, squares = 0;
    for (double v : c) mean += v / cells;
    for (double v : n) perCell += v / cells;
    for (double v : c) squares += (v - mean) * (v - mean);
    const double s = std::sqrt(squares / (cells - 1)), s0 = std::sqrt(mean * (1 - mean));
    const double sr = s0 / std::sqrt(perCell);

    const MixingSample sample = mixingSample(frame, unitCells);
    EXPECT_EQ(sample.cells, static_cast<int>(cells));
    EXPECT_NEAR(*sample.lacey, (s0 * s0 - s * s) / (s0 * s0 - sr * sr), 1e-12);
    EXPECT_NEAR(*sample.ashton, (std::log(s0) - std::log(s)) / (std::log(s0) - std::log(sr)), 1e-12);
    EXPECT_NEAR(*sample.stddev, s, 1e-14);
  }
}

TEST(Mixing, OrderOfParticlesDoesNotMatterAtAll) {
  const Frame frame = unevenBed(3);
  Frame shuffled = frame;
  Rng rng(4);
  for (std::size_t i = frame.size() - 1; i > 0; --i) {
    const std::size_t j = rng.next() % (i + 1);
    std::swap(shuffled.position[i], shuffled.position[j]);
    std::swap(shuffled.species[i], shuffled.species[j]);
  }
  ASSERT_NE(frame.position, shuffled.position);
  const MixingSample a = mixingSample(frame, unitCells), b = mixingSample(shuffled, unitCells);
  EXPECT_EQ(a.lacey, b.lacey);
  EXPECT_EQ(a.ashton, b.ashton);
  EXPECT_EQ(a.stddev, b.stddev);
}

TEST(Mixing, SwappedSpeciesAndMirroredBedReadTheSame) {
  const Frame frame = unevenBed(5);
  const MixingSample original = mixingSample(frame, unitCells);
  Frame swapped = frame, mirrored = frame;
  for (std::uint8_t& s : swapped.species) s = 1 - s;
  for (Vec2f& p : mirrored.position) p.x = 4.0f - p.x;
  for (const Frame& other : {swapped, mirrored}) {
    const MixingSample sample = mixingSample(other, unitCells);
    EXPECT_NEAR(*sample.lacey, *original.lacey, 1e-12);
    EXPECT_NEAR(*sample.ashton, *original.ashton, 1e-12);
    EXPECT_EQ(sample.cells, original.cells);
  }
}

TEST(Mixing, EdgesBelongToOneCell) {
  Frame frame;
  const auto add = [&frame](float x, float y) {
    frame.position.push_back({x, y});
    frame.species.push_back(1);
  };
  const SamplingGrid grid{2, 2, 1, 2.0, 2.0};
  for (float y : {0.0f, 1.0f, 2.0f})
    for (float x : {0.0f, 1.0f, 2.0f}) add(x, y);
  EXPECT_EQ(countCells(frame, grid).all, (std::vector<std::int32_t>{1, 2, 2, 4}));

  for (float outside : {-1e-6f, 2.000001f, 1e30f, -INFINITY, NAN}) {
    add(outside, 1.0f);
    add(1.0f, outside);
  }
  EXPECT_EQ(countCells(frame, grid).all, (std::vector<std::int32_t>{1, 2, 2, 4}));
  EXPECT_EQ(countCells(frame, grid).tracer, (std::vector<std::int32_t>{1, 2, 2, 4}));
}

}  // namespace
}  // namespace bedmix
