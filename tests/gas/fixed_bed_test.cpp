// SPDX-License-Identifier: MIT
#include "tests/gas/fixed_bed.h"

#include "engine/core/rng.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

TEST(FixedBed, PressureDropIsErgunsWithin002Percent) {
  for (GasScheme scheme : {GasScheme::projection, GasScheme::simple}) {
    Scene scene = test::paperScene(1.3);
    scene.gravity = 0.0;
    scene.bed.top = BedTop::lid;  // the bed fills the grid: no taper
    scene.gas->scheme = scheme;
    test::FixedBed bed(scene, test::squareLattice(scene));
    for (int i = 0; i < 400; ++i) ASSERT_TRUE(bed.step().solved);
    const double eps = 1.0 - std::numbers::pi / 6.0;  // spheres in cubes of their diameter
    const GasGrid& grid = bed.gas.grid();
    EXPECT_NEAR(bed.gas.fields().voidage[grid.cell(3, 7)], eps, 1e-12);
    double drop = 0.0;
    for (int c = 0; c < grid.columns; ++c)
      drop += (bed.gas.fields().pressure[grid.cell(c, 1)] - bed.gas.fields().pressure[grid.cell(c, 13)]) /
              grid.columns;
    EXPECT_NEAR(drop / (12 * 0.012 * test::ergunGradient(eps, 1.3, scene)), 1.0, 2e-4) << modelName(scheme);
  }
}

TEST(FixedBed, MomentumGivenIsMomentumTaken) {
  // A random bed on the incline: what the particles feel as drag and what stands in the gas equations must
  // cancel.
  const Scene scene = test::inclinedScene();
  Rng rng(7);
  std::vector<Vec2> centres;
  for (int i = 0; i < 700; ++i) {
    const double x = rng.uniform(0.002, 0.094);
    centres.push_back({x, rng.uniform(floorHeight(scene, x) + 0.001, 0.44)});
  }
  test::FixedBed bed(scene, centres);
  for (std::size_t i = 0; i < bed.particles.size(); ++i) {
    bed.particles.velocity[i].x = rng.uniform(-1.0, 1.0);
    bed.particles.velocity[i].y = rng.uniform(-1.0, 1.0);
  }
  for (int step = 0; step < 20; ++step) {
    bed.particles.foreseen = bed.particles.position;  // as if they had moved: nothing is owed
    ASSERT_TRUE(bed.step().solved);
    // Gas: drag in the momentum equations plus the cells' share of the pressure force, which the
    // volume-weighted face voidage makes the exact complement of the particles' share.
    const GasFields& gas = bed.gas.fields();
    const FaceLayout& layout = bed.gas.layout();
    const MomentumExchange& drag = bed.gas.exchange();
    Vec2 taken, given;
    double size = 0.0;
    const int firstLevel = layout.vFace(0, 0);
    for (int f = 0; f < layout.faces(); ++f) {
      const double force = drag.coefficient[f] * gas.velocity[f] - drag.source[f];
      (f < firstLevel ? taken.x : taken.y) += force;
      size += std::abs(force);
    }
    for (std::size_t i = 0; i < bed.particles.size(); ++i)
      given += bed.particles.external[i] - bed.particles.drag[i] * bed.particles.velocity[i];
    // The pressure part of the particles' force, cell by cell from the voidage itself.
    for (int c : layout.openCells) {
      const auto& [left, right, bottom, top] = layout.cellFaces[c];
      const auto gradient = [&](int a, int b) {
        double sum = 0.0;
        int n = 0;
        for (const MomentumVolume& v : layout.volumes)
          if (v.face == a || v.face == b) {
            sum += ((v.cellPlus < 0 ? 0.0 : gas.pressure[v.cellPlus]) - gas.pressure[v.cellMinus]) * v.area /
                   v.volume;
            ++n;
          }
        return n ? sum / n : 0.0;
      };
      const double solids = (1.0 - gas.voidage[c]) * layout.cellVolume[c];
      given += solids * Vec2{gradient(left, right), gradient(bottom, top)};
      size += solids * std::abs(gradient(bottom, top));
    }
    EXPECT_NEAR(given.x, taken.x, 1e-12 * size);
    EXPECT_NEAR(given.y, taken.y, 1e-12 * size);
  }
}

TEST(FixedBed, MassBalanceHoldsWhileParticlesMove) {
  Scene scene = test::paperScene(2.0);
  Rng rng(11);
  std::vector<Vec2> centres;
  for (int i = 0; i < 1000; ++i) centres.push_back({rng.uniform(0.002, 0.094), rng.uniform(0.002, 0.16)});
  for (GasScheme scheme : {GasScheme::projection, GasScheme::simple}) {
    scene.gas->scheme = scheme;
    test::FixedBed bed(scene, centres);
    for (int step = 0; step < 50; ++step) {
      for (std::size_t i = 0; i < bed.particles.size(); ++i)
        bed.particles.position[i].y += 1e-4 * (1.0 + 0.5 * std::sin(i));
      const GasStepReport r = bed.step();
      ASSERT_TRUE(r.solved);
      EXPECT_LT(r.massResidual, 1e-10);
    }
  }
}

}  // namespace
}  // namespace bedmix
