// SPDX-License-Identifier: MIT
#include "tests/effects/fluid_bed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace bedmix::test {
namespace {

using std::numbers::pi;

/// A deep box of liquid, so that what one bead does to it hardly matters.
Scene stillScene(double particleDensity, double viscosity) {
  Scene scene = lowScene(1, 0.0);
  scene.bed = {0.048, 0.12, 1.0};
  scene.particles.diameter = 0.002;
  scene.particles.density = particleDensity;
  scene.gas->density = 1000.0;
  scene.gas->viscosity = viscosity;
  scene.gas->step = 1e-4;
  scene.effects.at<VirtualMassSettings>().emplace();
  return scene;
}

/// Upward velocity after `seconds` of a bead let go at rest.
double velocityAfter(const Scene& scene, double seconds) {
  Simulation simulation = Simulation::make(scene, makeParticles(scene, {{0.0205, 0.0615}}));
  EXPECT_FALSE(simulation.advance(std::llround(seconds / tick(scene))));
  return static_cast<double>(simulation.frame()->velocity[0].y);
}

/// (rho - rho_p) g / (rho_p + C rho): a bubble starts with twice the acceleration of gravity. Before the
/// first gas step, which makes the liquid's pressure, all fall.
TEST(VirtualMass, ABodyLetGoAcceleratesWithWhatItTakesAlong) {
  for (const double density : {1.2, 300.0, 2500.0, 8000.0}) {
    Scene scene = stillScene(density, 1e-3);
    scene.effects.at<VirtualMassSettings>()->crowding = Crowding::none;
    const double gained = velocityAfter(scene, 2e-4) - velocityAfter(scene, 1e-4);
    const double expected = (1000.0 - density) * 9.81 / (density + 500.0) * 1e-4;
    EXPECT_NEAR(gained / expected, 1.0, 2e-3) << density;
  }
}

/// v = v_t (1 - e^(-t/tau)), tau = (rho_p + C rho) d^2/(18 mu), where Stokes's drag holds; the error is of
/// first order in the gas step.
TEST(VirtualMass, ABodyComesToStokesVelocityAsLateAsItShould) {
  Scene scene = stillScene(2500.0, 1.0);
  const double tau = 3000.0 * 4e-6 / 18.0, end = -1500.0 * 9.81 * 4e-6 / 18.0;
  const auto errorOf = [&](double gasStep) {
    scene.gas->step = gasStep;
    scene.time.step = 1e-6;
    const double time = 6.4e-4;
    return velocityAfter(scene, time) / (end * (1.0 - std::exp(-time / tau))) - 1.0;
  };
  EXPECT_NEAR(errorOf(1e-5), 0.0, 0.01);
  EXPECT_NEAR((errorOf(2e-5) - errorOf(1e-5)) / (errorOf(1e-5) - errorOf(5e-6)), 2.0, 0.1);
  scene.effects.at<VirtualMassSettings>().reset();
  EXPECT_GT(errorOf(1e-5), 0.05);  // it is too early without
}

TEST(VirtualMass, LeavesTheTerminalVelocityAlone) {
  Scene scene = stillScene(2500.0, 1.0);
  const double with = velocityAfter(scene, 0.01);  // 15 tau
  scene.effects.at<VirtualMassSettings>().reset();
  EXPECT_NEAR(with / velocityAfter(scene, 0.01), 1.0, 1e-5);
}

Scene vorticalScene(const VirtualMassSettings& settings) {
  Scene scene = stillScene(2500.0, 1e-3);
  scene.particles.diameter = 0.001;
  scene.bed.thickness = 0.004;
  scene.gas->step = 1e-3;
  scene.gravity = 0.0;
  *scene.effects.at<VirtualMassSettings>() = settings;
  return scene;
}

/// A lattice of beads in water with vortices.
struct VorticalBed : FluidBed {
  explicit VorticalBed(const VirtualMassSettings& settings)
      : FluidBed(vorticalScene(settings), squareLattice(vorticalScene(settings))) {
    setVelocity([](Vec2 at) {
      return Vec2{0.1 * std::sin(100.0 * at.x) * std::cos(70.0 * at.y), 0.1 * std::cos(90.0 * at.x + 1.0)};
    });
    for (std::size_t i = 0; i < particles().size(); ++i) {
      const double k = static_cast<double>(i);
      particles().velocity[i] = {0.1 * std::sin(k), 0.1 * std::cos(1.7 * k)};
    }
  }
};

TEST(VirtualMass, WhatTheGasGainsIsGivenInTheSameStep) {
  VorticalBed bed({});
  bed.charge();
  ASSERT_TRUE(bed.gas->advance(bed.voidage->voidage()).solved);
  Vec2 sum;
  double size = 0.0;
  for (const Vec2 f : bed.act()) sum += f, size += norm(f);
  EXPECT_GT(norm(sum), 1e-4 * size);
  EXPECT_LT(norm(sum + bed.onGas()), 1e-13 * size);
}

/// C rho V of the change of velocity, over the step that comes.
TEST(VirtualMass, WhatAParticleGainsIsTakenInTheNextStep) {
  VorticalBed bed({0.5, Crowding::none});
  bed.setVelocity([](Vec2) { return Vec2{0.3, 0.2}; });  // which does not change of itself
  bed.charge();
  bed.act();
  Vec2 gained;
  for (std::size_t i = 0; i < bed.particles().size(); ++i) {
    const double k = static_cast<double>(i);
    const Vec2 gain{0.1 + 0.01 * std::sin(k), 0.2};
    bed.particles().velocity[i] += gain;
    gained += gain;
  }
  bed.charge();
  const Vec2 expected = 0.5 * 1000.0 * pi / 6.0 * 1e-9 / 1e-3 * gained;
  // Those at the top are coupled in part only.
  const double coupled = bed.onGas().y / expected.y;
  EXPECT_GT(coupled, 0.95);
  EXPECT_LE(coupled, 1.0 + 1e-12);
}

/// (u grad) u of what turns like a solid points to the centre.
TEST(VirtualMass, GasThatCurvesPullsAlong) {
  Scene scene = stillScene(2500.0, 1e-3);
  scene.gravity = 0.0;
  FluidBed bed(scene, {{0.0331, 0.0712}});
  const double rate = 3.0;
  bed.setVelocity([&](Vec2 at) { return rate * Vec2{0.06 - at.y, at.x - 0.024}; });
  bed.charge();
  const Vec2 force = bed.act()[0], out = bed.particles().position[0] - Vec2{0.024, 0.06};
  const double voidage = 1.0, added = 500.0 * pi / 6.0 * 8e-9 * (3.0 - 2.0 * voidage) / voidage;
  EXPECT_NEAR(force.x / (-rate * rate * out.x * added), 1.0, 1e-3);
  EXPECT_NEAR(force.y / (-rate * rate * out.y * added), 1.0, 1e-3);
}

/// Zuber (1964): C (1 + 2 a)/(1 - a).
TEST(VirtualMass, IsLargerInDenseBeds) {
  VorticalBed alone({0.5, Crowding::none}), zuber({0.5, Crowding::zuber});
  alone.charge();
  zuber.charge();
  alone.act();
  zuber.act();
  const std::size_t middle = alone.particles().size() / 2;
  const double a = pi / 24.0;  // of spheres on a square lattice in a slab of four diameters
  const auto added = [&](FluidBed& bed) { return bed.particles().inert[middle] - bed.particles().mass; };
  EXPECT_NEAR(added(alone), 0.5 * 1000.0 * pi / 6.0 * 1e-9, 1e-18);
  EXPECT_NEAR(added(zuber) / added(alone), (1.0 + 2.0 * a) / (1.0 - a), 1e-3);
}

/// Beads that weigh a hundredth of the liquid rise calmly and lie densely under the lid, whatever the steps.
TEST(VirtualMass, LightBedsAreStable) {
  Scene scene = lowScene(250, 0.0);
  scene.bed.top = BedTop::lid;
  scene.particles.density = 10.0;
  scene.contacts.stiffness = 500.0;
  scene.gas->density = 1000.0;
  scene.gas->viscosity = 1e-3;
  scene.gas->step = 5e-4;
  scene.start.arrangement = Arrangement::drop;
  scene.limits.maxOverlap = 0.2;
  scene.effects.at<VirtualMassSettings>().emplace();
  Simulation calm = simulate(scene);
  EXPECT_EQ(calm.advance(std::llround(1.5 / tick(scene))), std::nullopt);
  EXPECT_LT(calm.report().largestSpeed, 0.6);
  const FramePtr frame = calm.frame();
  double low = scene.bed.height, fastest = 0.0;
  for (std::size_t i = 0; i < frame->size(); ++i) {
    low = std::min(low, static_cast<double>(frame->position[i].y));
    fastest = std::max(fastest, static_cast<double>(norm(frame->velocity[i])));
  }
  EXPECT_GT(low, 0.025);  // 19 rows
  EXPECT_LT(fastest, 0.05);
  scene.effects.at<VirtualMassSettings>().reset();
  Simulation wild = simulate(scene);
  EXPECT_TRUE(wild.advance(std::llround(0.05 / tick(scene))) || wild.report().largestSpeed > 5.0);
}

/// It is inertia of the motion through the gas: a contact lasts as long as that of so much heavier a body,
/// and particles turn as they do without.
TEST(VirtualMass, ParticlesTurnAsWithout) {
  for (const bool mixed : {false, true}) {
    Scene scene = lowScene(1, 0.0);
    scene.gas->density = 1000.0;
    if (mixed) scene.particles.size.emplace();
    scene.bed.thickness = 0.008;
    scene.effects.at<VirtualMassSettings>().emplace();
    FluidBed charged(scene, {{0.02, 0.05}});
    charged.charge();
    charged.act();
    const Particles& p = charged.particles();
    const double inertia = 0.4 * p.inert[0] * p.gyration[0] * p.gyration[0];
    EXPECT_GT(p.inert[0], 1.2 * p.massOf(0));
    EXPECT_NEAR(inertia / p.inertiaOf(0), 1.0, 1e-12);
  }
}

/// Everything at once, in several blocks, with particles that change places in memory.
Scene mixedScene() {
  Scene scene = lowScene(3000, 0.2);
  scene.bed.width = 0.24;
  scene.bed.height = 0.36;
  scene.bed.thickness = 0.006;
  scene.gas->grid = {{{20, 0.012}}, {{30, 0.012}}};
  scene.gas->inlets = {{0.0, 0.24, 0.2, std::nullopt}};
  scene.gas->density = 1000.0;
  scene.gas->viscosity = 1e-3;
  scene.particles.density = 2500.0;
  scene.particles.size.emplace();
  scene.start.arrangement = Arrangement::drop;
  scene.effects.at<LiftSettings>().emplace();
  scene.effects.at<VirtualMassSettings>().emplace();
  return scene;
}

TEST(VirtualMass, ThreadsAndBreaksChangeNothing) {
  for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::rk4}) {
    Scene scene = mixedScene();
    scene.time.integrator = integrator;
    const std::int64_t steps = integrator == Integrator::rk4 ? 200 : 2000;
    Simulation whole = simulate(scene), broken = simulate(scene, 3);
    ASSERT_FALSE(whole.advance(steps) || broken.advance(steps / 2 + 5));  // within a gas step
    StateWriter out(0);
    broken.save(out);
    const std::vector<std::byte> bytes = out.take();
    StateReader in(bytes);
    std::optional<Simulation> rest = Simulation::make(scene, in, 2);
    ASSERT_TRUE(rest && in.done());
    ASSERT_FALSE(rest->advance(steps / 2 - 5));
    EXPECT_EQ(whole.stateHash(), rest->stateHash());
  }
}

/// Steps are chosen by how fast drag changes: what collisions do to virtual mass within a step is no reason
/// for shorter ones.
TEST(VirtualMass, ChosenStepsAreAsLongAsWithout) {
  Scene scene = lowScene(150, 0.1);
  scene.gas->density = 1000.0;
  scene.gas->viscosity = 1e-3;
  scene.particles.density = 2500.0;
  scene.start.arrangement = Arrangement::drop;
  scene.time.step = scene.gas->step = StepLength::automatic();
  scene.time.integrator = Integrator::verletOnset;
  const auto stepsOf = [&] {
    Simulation simulation = simulate(scene);
    EXPECT_FALSE(simulation.advance(10 * stepsPerFrame(scene)));
    return static_cast<double>(simulation.gasSteps());
  };
  const double without = stepsOf();
  scene.effects.at<VirtualMassSettings>().emplace();
  scene.effects.at<LiftSettings>().emplace();
  EXPECT_LT(stepsOf(), 1.5 * without);
}

TEST(VirtualMass, NeedsGas) {
  Scene scene = lowScene(20, 1.0);
  scene.effects.at<VirtualMassSettings>().emplace();
  EXPECT_TRUE(contradictions(scene).empty());
  scene.gas.reset();
  EXPECT_EQ(contradictions(scene).at(0).path, "virtual_mass");
}

TEST(VirtualMass, LetsParticlesBeLighterThanTheGas) {
  Scene scene = lowScene(20, 0.1);
  scene.gas->density = 1000.0;
  scene.gas->viscosity = 1e-3;
  scene.particles.density = 600.0;
  EXPECT_NE(contradictions(scene).at(0).message.find("or [virtual_mass]"), std::string::npos);
  scene.effects.at<VirtualMassSettings>().emplace();
  EXPECT_TRUE(contradictions(scene).empty());
}

}  // namespace
}  // namespace bedmix::test
