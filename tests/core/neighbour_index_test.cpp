// SPDX-License-Identifier: MIT
#include "engine/core/neighbour_index.h"

#include "engine/core/rng.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bedmix {
namespace {

/// All pairs, and those as far as the last one share what places are left.
double bruteForce(const Frame& frame, std::size_t k) {
  const std::size_t n = frame.size();
  double unlike = 0.0, tracer = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    tracer += frame.species[i];
    std::vector<double> all, other;
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i) continue;
      const double x = static_cast<double>(frame.position[i].x) - static_cast<double>(frame.position[j].x);
      const double y = static_cast<double>(frame.position[i].y) - static_cast<double>(frame.position[j].y);
      all.push_back(x * x + y * y);
      if (frame.species[i] != frame.species[j]) other.push_back(all.back());
    }
    std::sort(all.begin(), all.end());
    const double last = all[k - 1];
    const auto below = [last](double d) { return d < last; };
    const double nearer = static_cast<double>(std::count_if(all.begin(), all.end(), below));
    const double asFar = static_cast<double>(std::count(all.begin(), all.end(), last));
    unlike += static_cast<double>(std::count_if(other.begin(), other.end(), below)) +
              (static_cast<double>(k) - nearer) *
                  static_cast<double>(std::count(other.begin(), other.end(), last)) / asFar;
  }
  const double p = tracer / static_cast<double>(n);
  return unlike / static_cast<double>(k * n) /
         (2 * p * (1 - p) * static_cast<double>(n) / static_cast<double>(n - 1));
}

/// A square lattice of unit spacing.
template <class Tracer>
Frame lattice(int side, const Tracer& tracer) {
  Frame frame;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y) {
      frame.position.push_back({static_cast<float>(x), static_cast<float>(y)});
      frame.species.push_back(tracer(x, y) ? 1 : 0);
    }
  return frame;
}

TEST(NeighbourIndex, CheckerboardHasItsClosedForm) {
  // Of the 4 nearest, inner particles have 4 unlike, those at a side 3, and at a corner 2.
  const int side = 20;
  const double n = side * side, inner = side - 2;
  const double unlike = inner * inner * 4 + 4 * inner * 3 + 4 * 2;
  const Frame frame = lattice(side, [](int x, int y) { return (x + y) % 2; });
  EXPECT_NEAR(*neighbourIndex(frame, 4), unlike / (4 * n) / (0.5 * n / (n - 1)), 1e-12);
  EXPECT_GT(*neighbourIndex(frame, 4), 1.85);
}

TEST(NeighbourIndex, SegregatedHalvesHaveTheirClosedForm) {
  // At the interface 1 of 4 is unlike; at its ends 1, and one of the two that share the fourth place.
  const int side = 20;
  const double n = side * side;
  const Frame frame = lattice(side, [](int x, int) { return x < 10; });
  EXPECT_NEAR(*neighbourIndex(frame, 4), 2 * (side - 2 + 2 * 1.5) / (4 * n) / (0.5 * n / (n - 1)), 1e-12);
  EXPECT_LT(*neighbourIndex(frame, 4), 0.06);
}

TEST(NeighbourIndex, AgreesWithAllPairs) {
  Rng rng(5);
  for (const int n : {2, 3, 7, 8, 50, 400}) {
    for (int shape = 0; shape < 6; ++shape) {
      Frame frame;
      for (int i = 0; i < n; ++i) {
        double x = rng.uniform(), y = rng.uniform();
        if (shape == 1) y *= y * y * y * 10;                           // dense below, dilute above
        if (shape == 2) y = 0.25;                                      // a line
        if (shape == 3) x = std::floor(5 * x), y = std::floor(5 * y);  // many at one place
        if (shape == 4 && i == 0) x = 1e30, y = -1e20;                 // one far away
        if (shape == 5) x = y = 1.0;                                   // all at one place
        frame.position.push_back({static_cast<float>(x), static_cast<float>(y)});
        frame.species.push_back(i == 0 || (i > 1 && rng.uniform() < 0.3));
      }
      for (const int k : {1, 6, 12})
        EXPECT_NEAR(*neighbourIndex(frame, k),
                    bruteForce(frame, static_cast<std::size_t>(std::min(k, n - 1))), 1e-12)
            << n << " particles, shape " << shape << ", " << k << " neighbours";
    }
  }
}

// With periodic sides no place is at a side: columns of a chequerboard have four unlike ones but for those
// above and below.
TEST(NeighbourIndex, GoesAroundPeriodicSides) {
  const int side = 20;
  const double n = side * side;
  Scene scene;
  scene.bed.width = side;
  scene.bed.sides = BedSides::periodic;
  const Frame frame = lattice(side, [](int x, int y) { return (x + y) % 2; });
  const double unlike = (n - 2 * side) * 4 + 2 * side * 3;
  EXPECT_NEAR(*neighbourIndex(frame, 4, Period(scene)), unlike / (4 * n) / (0.5 * n / (n - 1)), 1e-12);
  // And halves meet twice.
  const Frame halves = lattice(side, [](int x, int) { return x < 10; });
  EXPECT_NEAR(*neighbourIndex(halves, 4, Period(scene)),
              4 * (side - 2 + 2 * 1.5) / (4 * n) / (0.5 * n / (n - 1)), 1e-12);
}

TEST(NeighbourIndex, WhatIsNotDefinedIsEmpty) {
  EXPECT_FALSE(neighbourIndex(Frame{}));
  Frame frame = lattice(3, [](int, int) { return 1; });
  EXPECT_FALSE(neighbourIndex(frame));
  for (std::uint8_t& s : frame.species) s = 0;
  EXPECT_FALSE(neighbourIndex(frame));
  // A particle at no place is none.
  frame.species[0] = 1;
  frame.position[0].x = NAN;
  EXPECT_FALSE(neighbourIndex(frame));
  frame.position[1].y = INFINITY;
  frame.species[2] = 1;
  EXPECT_TRUE(neighbourIndex(frame));
}

}  // namespace
}  // namespace bedmix
