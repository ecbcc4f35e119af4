// SPDX-License-Identifier: MIT
#include "engine/core/particle_list.h"
#include "engine/core/rng.h"
#include "engine/coupling/exchange.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

/// Small heavy and large light particles at random places in gas that has run a few steps.
struct MixedBed {
  Scene scene;
  ThreadTeam team{1};
  GasSolver gas;
  VoidageField voidage;
  Exchange exchange;
  Particles particles;

  explicit MixedBed(const Scene& s)
      : scene(s), gas(s, team), voidage(s, gas.grid(), team), exchange(s, gas, voidage, team) {
    Rng rng(5);
    std::vector<Vec2> at;
    for (std::int64_t i = 0; i < scene.particles.count; ++i)
      at.push_back({rng.uniform(0.002, scene.bed.width - 0.002), rng.uniform(0.002, 0.7 * scene.bed.height)});
    std::sort(at.begin(), at.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
    particles = makeParticles(scene, at);
    for (Vec2& v : particles.velocity) v = {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    particles.addExternalForces();
    updateVoidage();
    gas.startWith(voidage.voidage());
  }

  void updateVoidage() { voidage.update(particles.position, particles.radii); }
  void gasStep() {
    updateVoidage();
    exchange.evaluateDrag(particles, gas.exchange());
    ASSERT_TRUE(gas.advance(voidage.voidage()).solved);
    exchange.applyForces(particles);
  }
};

Scene mixedScene() {
  Scene scene = test::paperScene(1.0);
  scene.particles.count = 700;
  scene.particles.size = SizeSettings{SizeDistribution::uniform, 0.1, 2.5};
  scene.particles.diameter = 0.003;
  scene.particles.species.push_back({"small", 300, 0.0015, 4000.0, std::nullopt});
  return scene;
}

TEST(MixedBed, SolidVolumeIsConserved) {
  MixedBed bed(mixedScene());
  const GasGrid& grid = bed.gas.grid();
  double solids = 0.0, spheres = 0.0;
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c)
      solids += (1.0 - bed.voidage.voidage()[grid.cell(c, r)]) * grid.volume(c, r);
  for (const double r : bed.particles.radii) spheres += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  EXPECT_NEAR(solids / spheres, 1.0, 1e-12);
}

TEST(MixedBed, DragIsThatOfEachOnesOwnDiameter) {
  for (std::size_t l = 0; l < modelTable<DragLaw>.size(); ++l) {
    Scene scene = mixedScene();
    scene.gas->drag = static_cast<DragLaw>(l);
    // One alone feels what the law says for its size.
    for (const double d : {0.0015, 0.003}) {
      Scene alike = scene;
      alike.particles.size.reset();
      alike.particles.species.clear();
      alike.particles.diameter = d;
      alike.particles.count = 1;
      MixedBed one(alike);
      Scene two = alike;  // the same one, called a kind of two
      two.particles.diameter = 0.003;
      two.particles.count = 1;
      two.particles.species.push_back({"only", 1, d, std::nullopt, std::nullopt});
      MixedBed other(two);
      one.gasStep();
      other.gasStep();
      EXPECT_NEAR(other.particles.drag[0] / one.particles.drag[0], 1.0, 1e-12)
          << modelTable<DragLaw>[l].name << ' ' << d;
      EXPECT_NEAR(other.particles.external[0].y / one.particles.external[0].y, 1.0, 1e-9);
    }
  }
}

/// What the faces are given is what the particles feel: coefficients, and sources with what is owed of the
/// step before.
TEST(MixedBed, FacesGetWhatTheParticlesFeel) {
  MixedBed bed(mixedScene());
  bed.gasStep();
  const Particles before = bed.particles;
  bed.exchange.evaluateDrag(bed.particles, bed.gas.exchange());
  const MomentumExchange& given = bed.gas.exchange();
  const Particles& p = bed.particles;
  const auto firstLevel = static_cast<std::size_t>(bed.gas.layout().vFace(0, 0));
  Vec2 coefficient, source, force;
  double drag = 0.0, size = 0.0;
  for (std::size_t f = 0; f < given.source.size(); ++f) {
    (f < firstLevel ? coefficient.x : coefficient.y) += given.coefficient[f];
    (f < firstLevel ? source.x : source.y) += given.source[f];
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    drag += p.drag[i];
    const Vec2 owed =
        before.drag[i] / static_cast<double>(bed.scene.gas->step) * (p.position[i] - before.foreseen[i]);
    force += p.drag[i] * p.velocity[i] + owed;
    size += norm(p.drag[i] * p.velocity[i]) + norm(owed);
  }
  EXPECT_NEAR(coefficient.x / drag, 1.0, 1e-12);
  EXPECT_NEAR(coefficient.y / drag, 1.0, 1e-12);
  EXPECT_NEAR(source.x, force.x, 1e-12 * size);
  EXPECT_NEAR(source.y, force.y, 1e-12 * size);
}

}  // namespace
}  // namespace bedmix
