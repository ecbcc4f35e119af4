// SPDX-License-Identifier: MIT
#include "engine/core/start_correlation.h"

#include "engine/core/rng.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

/// A tall bed whose x and y go together a little.
Frame bed(std::uint64_t seed, int n = 1000) {
  Rng rng(seed);
  Frame frame;
  for (int i = 0; i < n; ++i) {
    const double x = rng.uniform();
    frame.position.push_back({static_cast<float>(x), static_cast<float>(3.0 * rng.uniform() + 0.5 * x)});
    frame.id.push_back(3 * i);
  }
  return frame;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double n = static_cast<double>(a.size());
  double ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) ma += a[i] / n, mb += b[i] / n;
  for (std::size_t i = 0; i < a.size(); ++i)
    aa += (a[i] - ma) * (a[i] - ma), bb += (b[i] - mb) * (b[i] - mb), ab += (a[i] - ma) * (b[i] - mb);
  return ab / std::sqrt(aa * bb);
}

TEST(StartCorrelation, IsOneAtTheStartAndForAnyMoveOfTheWhole) {
  const Frame start = bed(1);
  const StartCorrelation correlate(start);
  EXPECT_NEAR(correlate.with(start)->index, 1.0, 1e-12);
  Frame moved = start;
  for (Vec2f& p : moved.position) p = {4.0f - 2.0f * p.x, 1.0f + 8.0f * p.y};
  EXPECT_NEAR(correlate.with(moved)->index, 1.0, 0.2);  // mirrored: x and y no longer go together
  for (std::size_t i = 0; i < start.size(); ++i) moved.position[i] = 2.0f * start.position[i];
  EXPECT_NEAR(correlate.with(moved)->index, 1.0, 1e-6);
}

TEST(StartCorrelation, IsOfTheOrderOfOneOverTheParticlesWhenNothingIsRemembered) {
  const StartCorrelation correlate(bed(1));
  double sum = 0.0;
  for (std::uint64_t seed = 2; seed < 52; ++seed) sum += correlate.with(bed(seed))->index / 50;
  EXPECT_GT(sum, 1e-3);
  EXPECT_LT(sum, 6e-3);
}

TEST(StartCorrelation, TellsTheDirectionThatMixesWorst) {
  const Frame start = bed(1), other = bed(2);
  const StartCorrelation correlate(start);
  Frame keptX = other, keptY = other;
  for (std::size_t i = 0; i < start.size(); ++i) {
    keptX.position[i].x = start.position[i].x;
    keptY.position[i].y = start.position[i].y;
  }
  const auto x = correlate.with(keptX), y = correlate.with(keptY);
  EXPECT_NEAR(std::abs(x->angle), 0.0, 0.25);
  EXPECT_NEAR(std::abs(y->angle), std::numbers::pi / 2, 0.25);
  EXPECT_GT(x->index, 0.6);
  EXPECT_GT(y->index, 0.6);
}

TEST(StartCorrelation, FollowsItsDefinition) {
  const Frame start = bed(1);
  Frame now = bed(2);
  for (std::size_t i = 0; i < now.size(); ++i)
    now.position[i] = now.position[i] + Vec2f{0.5f * start.position[i].y, 0.2f * start.position[i].x};
  std::vector<double> v[4];
  for (std::size_t i = 0; i < now.size(); ++i) {
    v[0].push_back(now.position[i].x), v[1].push_back(now.position[i].y);
    v[2].push_back(start.position[i].x), v[3].push_back(start.position[i].y);
  }
  // Power iteration on C^T C.
  double c[2][2], e[2] = {0.6, 0.8}, value = 0.0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) c[i][j] = correlation(v[i], v[2 + j]);
  for (int k = 0; k < 200; ++k) {
    const double u[2] = {c[0][0] * e[0] + c[0][1] * e[1], c[1][0] * e[0] + c[1][1] * e[1]};
    e[0] = c[0][0] * u[0] + c[1][0] * u[1], e[1] = c[0][1] * u[0] + c[1][1] * u[1];
    value = std::hypot(e[0], e[1]);
    e[0] /= value, e[1] /= value;
  }
  const auto found = StartCorrelation(start).with(now);
  EXPECT_NEAR(found->index, value / std::pow(1 + std::abs(correlation(v[2], v[3])), 2), 1e-9);
  EXPECT_NEAR(std::tan(found->angle), e[1] / e[0], 1e-6);
}

TEST(StartCorrelation, MatchesParticlesByIdWhereSomeComeAndGo) {
  const Frame start = bed(1), later = bed(2);
  Frame both, fewer, expectedStart;
  for (std::size_t i = start.size(); i-- > 0;) {  // in another order, every third gone
    if (i % 3 == 0) continue;
    fewer.position.push_back(later.position[i]);
    fewer.id.push_back(later.id[i]);
    expectedStart.position.push_back(start.position[i]);
    expectedStart.id.push_back(start.id[i]);
  }
  both = fewer;
  both.position.push_back({0.5f, 0.5f});  // one that was not there
  both.id.push_back(1);
  const auto expected = StartCorrelation(expectedStart).with(fewer);
  for (const Frame& frame : {fewer, both}) {
    EXPECT_NEAR(StartCorrelation(start).with(frame)->index, expected->index, 1e-12);
    EXPECT_NEAR(StartCorrelation(start).with(frame)->angle, expected->angle, 1e-9);
  }
}

TEST(StartCorrelation, WhatIsNotDefinedIsEmpty) {
  Frame frame = bed(1, 10);
  EXPECT_FALSE(StartCorrelation(Frame{}).with(Frame{}));
  EXPECT_FALSE(StartCorrelation(Frame{}).with(frame));
  Frame level = frame;
  for (Vec2f& p : level.position) p.y = 0.5f;
  EXPECT_FALSE(StartCorrelation(level).with(frame));
  frame.id.clear();
  EXPECT_FALSE(StartCorrelation(bed(1, 10)).with(frame));
}

}  // namespace
}  // namespace bedmix
