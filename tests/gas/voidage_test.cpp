// SPDX-License-Identifier: MIT
#include "engine/coupling/voidage.h"

#include "engine/core/rng.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bedmix {
namespace {

double solidVolume(const GasGrid& grid, const std::vector<double>& voidage) {
  double sum = 0.0;
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c) sum += (1.0 - voidage[grid.cell(c, r)]) * grid.volume(c, r);
  return sum;
}

TEST(Voidage, SolidVolumeIsConservedEverywhereIncludingStairAndTop) {
  const Scene scene = test::inclinedScene();
  const GasGrid grid = makeGasGrid(scene);
  ThreadTeam team(1);
  VoidageField field(scene, grid, team);
  Rng rng(3);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Vec2> at;
    double coupled = 0.0;
    for (int i = 0; i < 300; ++i) {
      // Up to a quarter of a diameter into the walls, into the stair and above the grid.
      const double x = rng.uniform(0.0015, 0.0945);
      at.push_back({x, rng.uniform(0.0015, 0.5)});
      const double s = std::clamp((0.42 - at.back().y) / 0.02, 0.0, 1.0);
      coupled += s * s * (3.0 - 2.0 * s);
    }
    field.update(at);
    EXPECT_NEAR(solidVolume(grid, field.voidage()) / (coupled * particleVolume(scene)), 1.0, 1e-10);
    for (int c = 0; c < grid.columns; ++c)
      for (int r = 0; r < grid.lowestRow[c]; ++r) EXPECT_EQ(field.voidage()[grid.cell(c, r)], 1.0);
  }
}

TEST(Voidage, ChangesContinuouslyAsAParticleCrossesCells) {
  const Scene scene = test::paperScene(1.0);
  const GasGrid grid = makeGasGrid(scene);
  ThreadTeam team(1);
  VoidageField field(scene, grid, team);
  const double step = 1e-6, d = scene.particles.diameter;
  // Per step, no cell's voidage may change by more than the share a move of that length can carry over one
  // edge, on each of two axes; the taper at the top is slower than that.
  const double bound = 2.0 * (step / d) * particleVolume(scene) / grid.volume(0, 0) * 1.0001;
  std::vector<double> before;
  for (double s = 0.0; s < 0.42; s += step * 997) {
    for (double at : {s, s + step}) {
      field.update({{0.002 + 0.2 * at, at + 0.002}});
      for (std::size_t c = 0; at > s && c < before.size(); ++c)
        EXPECT_LE(std::abs(field.voidage()[c] - before[c]), bound);
      before = field.voidage();
    }
  }
}

TEST(Voidage, WholeParticleInOneCell) {
  const Scene scene = test::paperScene(1.0);
  const GasGrid grid = makeGasGrid(scene);
  ThreadTeam team(1);
  VoidageField field(scene, grid, team);
  field.update({{0.018, 0.030}});
  EXPECT_NEAR(field.voidage()[grid.cell(1, 2)], 1.0 - particleVolume(scene) / grid.volume(1, 2), 1e-15);
  EXPECT_EQ(field.aboveGrid(), 0);
  field.update({{0.018, 0.43}});
  EXPECT_EQ(field.aboveGrid(), 1);
  EXPECT_EQ(field.lowest(), 1.0);
}

}  // namespace
}  // namespace bedmix
