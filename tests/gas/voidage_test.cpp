// SPDX-License-Identifier: MIT
#include "engine/coupling/voidage.h"

#include "engine/core/rng.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <numeric>

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
  VoidageField field(scene, grid);
  Rng rng(3);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> x, y;
    for (int i = 0; i < 300; ++i) {
      x.push_back(rng.uniform(0.0015, 0.0945));  // up to a quarter of a diameter into the walls
      y.push_back(rng.uniform(0.0015, 0.5));     // into the stair and above the grid
    }
    field.update(x, y);
    double coupled = 0.0;
    for (const VolumeShares& s : field.shares()) {
      coupled += s.coupling;
      EXPECT_NEAR(std::accumulate(s.share.begin(), s.share.end(), 0.0), s.coupling, 1e-15);
      for (double share : s.share) EXPECT_GE(share, 0.0);
    }
    EXPECT_NEAR(solidVolume(grid, field.voidage()) / (coupled * particleVolume(scene)), 1.0, 1e-10);
    for (int c = 0; c < grid.columns; ++c)
      for (int r = 0; r < grid.lowestRow[c]; ++r) EXPECT_EQ(field.voidage()[grid.cell(c, r)], 1.0);
  }
}

TEST(Voidage, ChangesContinuouslyAsAParticleCrossesCells) {
  const Scene scene = test::paperScene(1.0);
  const GasGrid grid = makeGasGrid(scene);
  VoidageField field(scene, grid);
  const double step = 1e-6, d = scene.particles.diameter;
  // Per step, no cell's voidage may change by more than the share a move of that length can carry over one
  // edge, on each of two axes; the taper at the top is slower than that.
  const double bound = 2.0 * (step / d) * particleVolume(scene) / grid.volume(0, 0) * 1.0001;
  std::vector<double> before;
  for (double s = 0.0; s < 0.42; s += step * 997) {
    for (double at : {s, s + step}) {
      field.update(std::vector{0.002 + 0.2 * at}, std::vector{at + 0.002});
      for (std::size_t c = 0; at > s && c < before.size(); ++c)
        EXPECT_LE(std::abs(field.voidage()[c] - before[c]), bound);
      before = field.voidage();
    }
  }
}

TEST(Voidage, WholeParticleInOneCell) {
  const Scene scene = test::paperScene(1.0);
  const GasGrid grid = makeGasGrid(scene);
  VoidageField field(scene, grid);
  field.update(std::vector{0.018}, std::vector{0.030});
  EXPECT_NEAR(field.voidage()[grid.cell(1, 2)], 1.0 - particleVolume(scene) / grid.volume(1, 2), 1e-15);
  EXPECT_EQ(field.aboveGrid(), 0);
  field.update(std::vector{0.018}, std::vector{0.43});
  EXPECT_EQ(field.aboveGrid(), 1);
  EXPECT_EQ(field.lowest(), 1.0);
}

}  // namespace
}  // namespace bedmix
