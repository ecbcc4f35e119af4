// SPDX-License-Identifier: MIT
#include "engine/core/mixing_indices.h"

#include "engine/core/rng.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>
#include <string>

namespace bedmix {
namespace {

/// All indices by name; what is not defined is not there.
using Values = std::map<std::string, double>;

Values valuesOf(const CellStatistics& cells, const Frame& frame = {}, const Frame& start = {}) {
  const StartCorrelation correlation(start);
  Values values;
  for (const MixingIndex& index : mixingIndices())
    if (const auto value = index.of({frame, cells, correlation})) values[std::string(index.name)] = *value;
  return values;
}
Values valuesOf(const CellCounts& counts) { return valuesOf(cellStatistics(counts, 1)); }

constexpr SamplingGrid unitCells{4, 15, 12, 4.0, 15.0};

/// An uneven bed of 4 x 15 unit cells in which tracer and height go together.
Frame unevenBed(std::uint64_t seed) {
  Rng rng(seed);
  Frame frame;
  for (int i = 0; i < 1500; ++i) {
    const auto x = static_cast<float>(rng.uniform(0.0, 4.0));
    const auto y = static_cast<float>(rng.uniform(0.0, rng.uniform() < 0.7 ? 8.0 : 15.0));
    frame.position.push_back({x, y});
    frame.species.push_back(rng.uniform() < 0.2 + 0.15 * x);
    frame.id.push_back(i);
  }
  return frame;
}
Values valuesOf(const Frame& frame, const Frame& start) {
  return valuesOf(cellStatistics(countCells(frame, unitCells), unitCells.minParticles), frame, start);
}

void shuffle(std::vector<std::uint8_t>& tags, Rng& rng) {
  for (std::size_t i = tags.size() - 1; i > 0; --i) std::swap(tags[i], tags[rng.next() % (i + 1)]);
}

TEST(MixingIndices, SegregatedCellsHaveTheirClosedForms) {
  CellCounts counts;
  for (int c = 0; c < 60; ++c) {
    counts.all.push_back(25);
    counts.tracer.push_back(c < 30 ? 25 : 0);
  }
  Values of = valuesOf(counts);
  const double s = 0.5 * std::sqrt(60.0 / 59);
  EXPECT_NEAR(of.at("lacey"), -(1.0 / 59) / (1 - 1.0 / 25), 1e-14);
  EXPECT_NEAR(of.at("kramers"), (0.5 - s) / (0.5 - 0.1), 1e-14);
  EXPECT_NEAR(of.at("poole"), s / 0.1, 1e-13);
  EXPECT_NEAR(of.at("rose"), 1 - s / 0.5, 1e-14);
  EXPECT_NEAR(of.at("danckwerts"), 60.0 / 59, 1e-14);
  EXPECT_EQ(of.at("entropy"), 0.0);
  EXPECT_NEAR(of.at("lacey_weighted"), 0.0, 1e-15);
  // In cells however unlike the weighted index is 0, Lacey's anything.
  of = valuesOf(CellCounts{{3, 50, 7, 40}, {3, 0, 0, 40}});
  EXPECT_NEAR(of.at("lacey_weighted"), 0.0, 1e-15);
  EXPECT_LT(of.at("lacey"), -0.3);
}

TEST(MixingIndices, EqualCellsAreMixedPerfectly) {
  const Values of =
      valuesOf(CellCounts{std::vector<std::int32_t>(60, 24), std::vector<std::int32_t>(60, 12)});
  EXPECT_NEAR(of.at("lacey"), 1 / (1 - 1.0 / 24), 1e-14);
  EXPECT_FALSE(of.contains("ashton"));
  EXPECT_NEAR(of.at("kramers"), 1 / (1 - std::sqrt(1.0 / 24)), 1e-14);
  EXPECT_EQ(of.at("poole"), 0.0);
  EXPECT_EQ(of.at("rose"), 1.0);
  EXPECT_EQ(of.at("danckwerts"), 0.0);
  EXPECT_NEAR(of.at("entropy"), 1.0, 1e-14);
  EXPECT_NEAR(of.at("lacey_weighted"), (1440.0 - 1) / (1440 - 60), 1e-14);
}

TEST(MixingIndices, StripesOfTwoFractionsHaveTheirClosedForms) {
  CellCounts counts;  // a quarter and three quarters in turn
  for (int c = 0; c < 60; ++c) {
    counts.all.push_back(16);
    counts.tracer.push_back(c % 2 ? 4 : 12);
  }
  const Values of = valuesOf(counts);
  const double s2 = 60.0 / 59 / 16, h = -(0.25 * std::log(0.25) + 0.75 * std::log(0.75)) / std::log(2.0);
  EXPECT_NEAR(of.at("lacey"), (0.25 - s2) / (0.25 - 0.25 / 16), 1e-14);
  EXPECT_NEAR(of.at("ashton"), std::log(0.25 / s2) / std::log(16.0), 1e-14);
  EXPECT_NEAR(of.at("kramers"), (0.5 - std::sqrt(s2)) / (0.5 - 0.125), 1e-14);
  EXPECT_NEAR(of.at("poole"), std::sqrt(s2) / 0.125, 1e-13);
  EXPECT_NEAR(of.at("rose"), 1 - 2 * std::sqrt(s2), 1e-14);
  EXPECT_NEAR(of.at("danckwerts"), 4 * s2, 1e-14);
  EXPECT_NEAR(of.at("entropy"), h, 1e-14);
  EXPECT_NEAR(of.at("lacey_weighted"), 0.75 / (1 - 59.0 / 959), 1e-14);
}

TEST(MixingIndices, WeightedAndNearestNeighbourMeanExactlyOneOverAllWaysToTag) {
  Rng rng(3);
  Frame frame;
  for (int i = 0; i < 12; ++i)
    frame.position.push_back({static_cast<float>(rng.uniform()), static_cast<float>(rng.uniform())});
  const std::vector<int> sizes{2, 3, 7};
  for (const int tagged : {2, 6, 9}) {
    double weighted = 0.0, neighbours = 0.0, plain = 0.0;
    int ways = 0;
    for (unsigned tags = 0; tags < 1u << 12; ++tags) {
      if (std::popcount(tags) != tagged) continue;
      CellCounts counts;
      unsigned rest = tags;
      for (const int n : sizes) {
        counts.all.push_back(n);
        counts.tracer.push_back(std::popcount(rest & ((1u << n) - 1)));
        rest >>= n;
      }
      frame.species.clear();
      for (int i = 0; i < 12; ++i) frame.species.push_back(tags >> i & 1u);
      const Values of = valuesOf(cellStatistics(counts, 1), frame);
      weighted += of.at("lacey_weighted");
      neighbours += of.at("nearest_neighbour");
      plain += of.contains("lacey") ? of.at("lacey") : 0.0;
      ++ways;
    }
    EXPECT_NEAR(weighted / ways, 1.0, 1e-13) << tagged;
    EXPECT_NEAR(neighbours / ways, 1.0, 1e-13) << tagged;
    EXPECT_GT(std::abs(plain / ways - 1.0), 0.03) << tagged;
  }
}

/// Mean and standard error of each index over random tags at fixed positions.
struct Estimate {
  double sum = 0.0, squares = 0.0;
  int draws = 0;

  double mean() const { return sum / draws; }
  double error() const { return std::sqrt((squares / draws - mean() * mean()) / draws); }
};
std::map<std::string, Estimate> estimates(Frame frame, const SamplingGrid& grid, double fraction, int draws,
                                          bool cellsOnly = false) {
  Rng rng(17);
  frame.species.assign(frame.size(), 0);
  std::fill_n(frame.species.begin(), static_cast<std::size_t>(fraction * static_cast<double>(frame.size())),
              1);
  std::map<std::string, Estimate> all;
  for (int d = 0; d < draws; ++d) {
    shuffle(frame.species, rng);
    for (const auto& [name, value] :
         valuesOf(cellStatistics(countCells(frame, grid), grid.minParticles), cellsOnly ? Frame{} : frame)) {
      Estimate& e = all[name];
      e.sum += value, e.squares += value * value, ++e.draws;
    }
  }
  return all;
}

TEST(MixingIndices, DiluteFreeboardFoolsLaceyButNotTheWeightedIndex) {
  Rng rng(8);
  Frame frame;  // 97 % of the particles in the lower quarter of a box
  for (int i = 0; i < 9240; ++i) {
    const auto y = static_cast<float>(i < 8963 ? rng.uniform(0.0, 0.25) : rng.uniform(0.25, 1.0));
    frame.position.push_back({static_cast<float>(rng.uniform()), y});
  }
  auto all = estimates(frame, {12, 12, 1, 1.0, 1.0}, 0.5, 100, true);
  EXPECT_LT(all["lacey"].mean(), 0.7);
  EXPECT_NEAR(all["lacey_weighted"].mean(), 1.0, 4 * all["lacey_weighted"].error());
  EXPECT_LT(all["lacey_weighted"].error(), 2e-4);
  // Without the dilute cells Lacey's is right, too.
  auto dense = estimates(frame, {12, 12, 32, 1.0, 1.0}, 0.5, 100, true);
  EXPECT_NEAR(dense["lacey"].mean(), 1.0, 1e-3);
  EXPECT_NEAR(dense["lacey_weighted"].mean(), 1.0, 4 * dense["lacey_weighted"].error());
}

TEST(MixingIndices, RandomTagsReadOneAtAnyFraction) {
  const Frame bed = unevenBed(2);
  for (const double fraction : {0.1, 0.5, 0.8}) {
    auto all = estimates(bed, unitCells, fraction, 100);
    for (const std::string name : {"lacey_weighted", "nearest_neighbour", "gmmi_x", "gmmi_y"}) {
      EXPECT_NEAR(all[name].mean(), 1.0, 4 * all[name].error()) << name << ' ' << fraction;
      EXPECT_LT(all[name].error(), 0.01);
    }
  }
}

TEST(MixingIndices, EntropyOfRandomTagsIsItsHypergeometricMean) {
  Frame frame;  // 60 cells of 25
  for (int i = 0; i < 1500; ++i)
    frame.position.push_back({static_cast<float>(i % 4) + 0.5f, static_cast<float>(i / 4 % 15) + 0.5f});
  auto all = estimates(frame, {4, 15, 1, 4.0, 15.0}, 0.3, 400, true);
  const auto choose = [](double n, double k) {
    return std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1);
  };
  double expected = 0.0;
  for (int t = 0; t <= 25; ++t)
    expected += std::exp(choose(450, t) + choose(1050, 25 - t) - choose(1500, 25)) * mixtureEntropy(t / 25.0);
  EXPECT_NEAR(all["entropy"].mean(), expected / mixtureEntropy(0.3), 4 * all["entropy"].error());
  EXPECT_LT(all["entropy"].mean(), 0.98);  // random is less than perfect
}

TEST(MixingIndices, CellBasedOnesFollowTheirDefinitions) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Frame frame = unevenBed(seed);
    std::vector<double> c, n;
    for (int cell = 0; cell < 60; ++cell) {
      double all = 0, tracer = 0;
      for (std::size_t i = 0; i < frame.size(); ++i)
        if (static_cast<int>(frame.position[i].x) + 4 * static_cast<int>(frame.position[i].y) == cell)
          ++all, tracer += frame.species[i];
      if (all >= 12) c.push_back(tracer / all), n.push_back(all);
    }
    const double k = static_cast<double>(c.size()), total = std::accumulate(n.begin(), n.end(), 0.0);
    double mean = 0, p = 0, s2 = 0, weighted = 0, h = 0;
    for (std::size_t i = 0; i < c.size(); ++i) mean += c[i] / k, p += n[i] * c[i] / total;
    for (std::size_t i = 0; i < c.size(); ++i) {
      s2 += (c[i] - mean) * (c[i] - mean) / (k - 1);
      weighted += n[i] * (c[i] - p) * (c[i] - p) / total;
      if (c[i] > 0 && c[i] < 1) h -= n[i] / total * (c[i] * std::log(c[i]) + (1 - c[i]) * std::log(1 - c[i]));
    }
    const double s = std::sqrt(s2), s0 = std::sqrt(mean * (1 - mean)), sr = s0 / std::sqrt(total / k);
    const Values of = valuesOf(frame, frame);
    EXPECT_NEAR(of.at("kramers"), (s0 - s) / (s0 - sr), 1e-12);
    EXPECT_NEAR(of.at("poole"), s / sr, 1e-12);
    EXPECT_NEAR(of.at("rose"), 1 - s / s0, 1e-12);
    EXPECT_NEAR(of.at("danckwerts"), s2 / (s0 * s0), 1e-12);
    EXPECT_NEAR(of.at("entropy"), h / -(p * std::log(p) + (1 - p) * std::log(1 - p)), 1e-12);
    EXPECT_NEAR(of.at("lacey_weighted"),
                (p * (1 - p) - weighted) / (p * (1 - p) * (1 - (k - 1) / (total - 1))), 1e-12);
  }
}

TEST(MixingIndices, OrderOfParticlesDoesNotMatter) {
  const Frame start = unevenBed(3);
  Frame frame = unevenBed(4), other;
  std::vector<std::size_t> order(frame.size());
  std::iota(order.begin(), order.end(), 0);
  Rng rng(4);
  for (std::size_t i = order.size() - 1; i > 0; --i) std::swap(order[i], order[rng.next() % (i + 1)]);
  for (const std::size_t i : order) {
    other.position.push_back(frame.position[i]);
    other.species.push_back(frame.species[i]);
    other.id.push_back(frame.id[i]);
  }
  const Values a = valuesOf(frame, start), b = valuesOf(other, start);
  ASSERT_EQ(a.size(), mixingIndices().size());
  for (const auto& [name, value] : a) {
    const bool sums = name.starts_with("gmmi") || name == "principal_component";
    EXPECT_NEAR(value, b.at(name), sums ? 1e-12 : 0.0) << name;
  }
}

TEST(MixingIndices, SwappedSpeciesReadTheSame) {
  const Frame frame = unevenBed(5);
  Frame swapped = frame;
  double p = 0.0;
  for (std::uint8_t& s : swapped.species) p += s / 1500.0, s = 1 - s;
  const Values a = valuesOf(frame, frame), b = valuesOf(swapped, frame);
  for (const auto& [name, value] : a) {
    if (name.starts_with("gmmi"))  // the centre of all lies between those of the species
      EXPECT_NEAR(p * value + (1 - p) * b.at(name), 1.0, 1e-12);
    else
      EXPECT_NEAR(value, b.at(name), 1e-12) << name;
  }
}

TEST(MixingIndices, MeanPositionOfHalvesAndOfStripes) {
  Frame frame;
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 4; ++y) {
      frame.position.push_back({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
      frame.species.push_back(x < 4);
    }
  EXPECT_EQ(*meanPositionIndex(frame).x, 0.5);
  EXPECT_EQ(*meanPositionIndex(frame).y, 1.0);
  for (std::size_t i = 0; i < frame.size(); ++i) frame.species[i] = i / 4 % 4 == 0 || i / 4 % 4 == 3;
  EXPECT_EQ(*meanPositionIndex(frame).x, 1.0);  // layers with one centre look mixed to it
}

TEST(MixingIndices, OneSpeciesOrNothingHasNone) {
  Frame frame = unevenBed(1);
  frame.species.assign(frame.size(), 1);
  const Values of = valuesOf(frame, frame);
  EXPECT_EQ(of.size(), 1u);  // where particles started does not depend on their colour
  EXPECT_NEAR(of.at("principal_component"), 1.0, 1e-12);
  EXPECT_TRUE(valuesOf(Frame{}, Frame{}).empty());
}

TEST(MixingIndices, AreAllDocumented) {
  std::ifstream file(BEDMIX_SOURCE_DIR "/assets/docs/indices.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const MixingIndex& index : mixingIndices()) {
    EXPECT_NE(text.find("`" + std::string(index.name) + "`"), std::string::npos) << index.name;
    if (index.needs == "cells") {
      EXPECT_NE(text.find(index.formula), std::string::npos) << index.formula;
    }
  }
}

}  // namespace
}  // namespace bedmix
