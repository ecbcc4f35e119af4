// SPDX-License-Identifier: MIT
#include "replay/analysis/circulation.h"

#include "tests/replay/analysis_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix::test {
namespace {

TEST(Circulation, OfOneRollIsItsStreamFunctionsHeight) {
  // v = (dpsi/dy, -dpsi/dx), psi = A sin(pi x/W) sin(pi y/H), in a bed evenly filled.
  const Scene scene = syntheticScene(false, false);
  const double w = scene.bed.width, h = scene.bed.height, a = 0.002, pi = std::numbers::pi;
  const double spacing = 0.001;
  const std::vector<Vec2> places = lattice(w, h, spacing);
  Frame frame = frameOf(0.0, places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double x = pi * places[i].x / w, y = pi * places[i].y / h;
    frame.velocity[i] =
        toFloat({a * pi / h * std::sin(x) * std::cos(y), -a * pi / w * std::cos(x) * std::sin(y)});
  }
  Circulation analysis({scene, 2, 0.01});
  analysis.accept(frame);
  analysis.accept(frame);
  const double perArea = particleMass(scene) / (spacing * spacing);
  EXPECT_NEAR(found(analysis, "circulation_rate") / (perArea * a), 1.0, 0.003);
  EXPECT_NEAR(found(analysis, "circulation_turnover") / (w * h / a), 1.0, 0.003);

  const Table cells = tableOf(analysis, "circulation");
  ASSERT_EQ(cells.rows(), 6u * 15u);
  EXPECT_EQ(at(cells, "particles", 0), 64.0);
  EXPECT_NEAR(at(cells, "solids_fraction", 0), 64.0 * particleVolume(scene) / (0.008 * 0.008 * 0.004), 1e-9);
  EXPECT_NEAR(at(cells, "y", 7 * 6), 0.06, 1e-12);
  EXPECT_NEAR(at(cells, "v", 7 * 6), -a * pi / w * std::cos(pi / 12.0), 0.02 * a * pi / w);
  EXPECT_EQ(tableOf(analysis, "circulation_cells").rows(), 6u);
}

TEST(Circulation, IsNoneWhereNothingMoves) {
  const Scene scene = syntheticScene(false, false);
  Circulation analysis({scene, 1, 0.0});
  analysis.accept(frameOf(0.0, {{0.01, 0.01}}));
  EXPECT_EQ(found(analysis, "circulation_rate"), 0.0);
  EXPECT_TRUE(std::isnan(found(analysis, "circulation_turnover")));
}

}  // namespace
}  // namespace bedmix::test
