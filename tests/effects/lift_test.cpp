// SPDX-License-Identifier: MIT
#include "engine/effects/lift_laws.h"
#include "tests/effects/fluid_bed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace bedmix::test {
namespace {

using std::numbers::pi;

/// Water in a box of unequal cells, and beads of 2 mm.
Scene waterScene() {
  Scene scene = lowScene(1, 0.0);
  scene.bed.thickness = 0.02;
  scene.particles.diameter = 0.002;
  scene.particles.density = 2500.0;
  scene.gas->density = 1000.0;
  scene.gas->viscosity = 1e-3;
  scene.gas->step = 1e-3;
  scene.gas->grid = {{{6, 0.004}, {3, 0.008}}, {{10, 0.004}, {10, 0.008}}};
  scene.gravity = 0.0;
  scene.effects.at<LiftSettings>().emplace();
  return scene;
}

constexpr LiftSettings byShear{ShearLift::mei, SpinLift::none}, bySpin{ShearLift::none, SpinLift::lunLiu};

LiftLaw lawOf(const LiftSettings& models) { return {*waterScene().gas, models}; }
struct Effect {
  double lift = 0.0, resistance = 0.0;
};
Effect effect(const LiftLaw& law, double slip, double vorticity, double spin, double d = 0.002) {
  Effect e;
  law.evaluate({1, &slip, &vorticity, &spin, &d}, &e.lift, &e.resistance);
  return e;
}

/// Saffman's force 6.46 mu a^2 U sqrt(G/nu) (1968) where inertia is small.
TEST(Lift, IsSaffmansWhereReynoldsNumbersAreSmall) {
  const LiftLaw law = lawOf(byShear);
  const double nu = 1e-6, d = 1e-5, shear = 100.0, slip = 1e-3;  // Re = 0.01, Re_G = 0.01
  const double force = effect(law, slip, shear, 0.0, d).lift * slip;
  const double saffman = 6.46 * 1e-3 * 0.25 * d * d * slip * std::sqrt(shear / nu);
  EXPECT_NEAR(force / saffman, 1.0, 1.5e-3);
  EXPECT_EQ(effect(law, slip, -shear, 0.0, d).lift * slip, -force);
  EXPECT_EQ(effect(law, slip, 0.0, 0.0, d).lift, 0.0);
  EXPECT_TRUE(std::isfinite(effect(law, 0.0, shear, 0.0, d).lift));
}

/// Mei's (1992) fit of Dandy & Dwyer's (1990) simulations, F/F_Saffman over Re and b = G d/(2 U), worked out.
TEST(Lift, LosesWithTheReynoldsNumberWhatMeiSays) {
  const LiftLaw law = lawOf(byShear);
  const double nu = 1e-6, d = 0.002;
  const auto ratio = [&](double reynolds, double alpha) {
    const double slip = reynolds * nu / d, shear = 2.0 * alpha * slip / d;
    return effect(law, slip, shear, 0.0).lift / (1.615 * 1e-3 * d * d * std::sqrt(shear / nu));
  };
  EXPECT_NEAR(ratio(0.1, 0.1), 0.9911, 1e-4);
  EXPECT_NEAR(ratio(1.0, 0.1), 0.9148, 1e-4);
  EXPECT_NEAR(ratio(10.0, 0.1), 0.4341, 1e-4);
  EXPECT_NEAR(ratio(10.0, 0.4), 0.5004, 1e-4);
  EXPECT_NEAR(ratio(40.0, 0.1), 0.1212, 1e-4);
  EXPECT_NEAR(ratio(100.0, 0.1), 0.1657, 1e-4);
  EXPECT_NEAR(ratio(40.0001, 0.1), 0.1048, 1e-4);
}

TEST(Lift, IsRubinowAndKellersBySpin) {
  const LiftLaw law = lawOf(bySpin);
  const double d = 1e-4, slip = 5e-3, spin = 40.0, vorticity = 10.0;  // Re = 0.5
  const Effect e = effect(law, slip, vorticity, spin, d);
  EXPECT_NEAR(e.lift, pi / 8.0 * d * d * d * 1000.0 * (spin - 0.5 * vorticity), 1e-12 * e.lift);
  EXPECT_NEAR(e.resistance, pi * 1e-3 * d * d * d, 1e-12 * e.resistance);
  EXPECT_EQ(effect(law, slip, 2.0 * spin, spin, d).lift, 0.0);
}

/// Lun & Liu (1997) above Re = 1 and Dennis et al. (1980) above Re_s = 32, which both begin there.
TEST(Lift, BySpinIsWeakerAndResistanceLargerAtLargeReynoldsNumbers) {
  const LiftLaw law = lawOf(bySpin);
  const double d = 0.002, magnus = pi / 8.0 * d * d * d * 1000.0, couple = pi * 1e-3 * d * d * d;
  EXPECT_NEAR(effect(law, 1.000001 / 2000.0, 0.0, 1.0).lift / magnus, 1.0, 1e-6);
  EXPECT_NEAR(effect(law, 100.0 / 2000.0, 0.0, 1.0).lift / magnus, 0.178 + 0.822 * std::pow(100.0, -0.522),
              1e-9);
  const double spin = 100.0, reynolds = 1000.0 * d * d * spin / 1e-3;  // 400
  // Dennis et al.: T = C rho/2 (d/2)^5 spin^2, C = 12.9 Re_s^-0.5 + 128.4/Re_s
  const double torque =
      (12.9 / std::sqrt(reynolds) + 128.4 / reynolds) * 500.0 * std::pow(d / 2.0, 5) * spin * spin;
  EXPECT_NEAR(effect(law, 0.0, 0.0, spin).resistance * spin / torque, 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(effect(law, 0.0, 0.0, 7.0).resistance, couple);
  EXPECT_NEAR(effect(law, 0.0, 0.0, 31.7 / 4.0).resistance / couple, 1.0, 1e-3);
}

/// In a flow that is linear in space: where faces' velocities are interpolated between, whatever the cells.
TEST(Lift, SeesTheVorticityOfLinearFlow) {
  const Scene scene = waterScene();
  // Mid-cell, across where cells change, near a face; away from the walls' half cells.
  FluidBed bed(scene, {{0.0131, 0.0177}, {0.0239, 0.0391}, {0.0271, 0.0433}, {0.0405, 0.0811}});
  bed.setVelocity([](Vec2 at) { return Vec2{0.01 + 3.0 * at.y - at.x, 0.02 + 7.0 * at.x + at.y}; });
  for (std::size_t i = 0; i < 4; ++i) {
    bed.particles().velocity[i] = {0.03, -0.02};
    bed.particles().spin[i] = 20.0;
  }
  bed.charge();
  const std::vector<Vec2> force = bed.act();
  const LiftLaw law = lawOf({});
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 at = bed.particles().position[i];
    const Vec2 w = Vec2{0.01 + 3.0 * at.y - at.x, 0.02 + 7.0 * at.x + at.y} - Vec2{0.03, -0.02};
    const double size = effect(law, norm(w), 7.0 - 3.0, 20.0).lift;
    EXPECT_NEAR(force[i].x, size * w.y, 1e-9 * size * norm(w)) << i;
    EXPECT_NEAR(force[i].y, -size * w.x, 1e-9 * size * norm(w)) << i;
  }
}

/// Who lags behind in a shear is driven to where the gas is faster, Saffman (1965); a ball with backspin,
/// which turns up in front, rises.
TEST(Lift, PointsWhereItShould) {
  Scene scene = waterScene();
  *scene.effects.at<LiftSettings>() = byShear;
  FluidBed sheared(scene, {{0.02, 0.03}});
  sheared.setVelocity([](Vec2 at) { return Vec2{5.0 * at.y, 0.0}; });
  sheared.charge();
  const Vec2 up = sheared.act()[0];
  EXPECT_GT(up.y, 0.0);
  EXPECT_EQ(up.x, 0.0);

  *scene.effects.at<LiftSettings>() = bySpin;
  FluidBed still(scene, {{0.02, 0.03}});
  still.particles().velocity[0] = {0.1, 0.0};
  still.particles().spin[0] = 50.0;
  still.charge();
  EXPECT_GT(still.act()[0].y, 0.0);
}

Scene stirredScene() {
  Scene scene = waterScene();
  scene.particles.diameter = 0.001;
  scene.bed.thickness = 0.004;
  return scene;
}

/// A lattice of beads in a flow with vortices, from wall to wall.
struct StirredBed : FluidBed {
  explicit StirredBed(int threads = 1) : FluidBed(stirredScene(), squareLattice(stirredScene()), threads) {
    setVelocity([](Vec2 at) {
      return Vec2{0.1 * std::sin(100.0 * at.x) * std::cos(70.0 * at.y), 0.1 * std::cos(90.0 * at.x + 1.0)};
    });
    for (std::size_t i = 0; i < particles().size(); ++i) {
      const double k = static_cast<double>(i);
      particles().velocity[i] = {0.1 * std::sin(k), 0.1 * std::cos(1.7 * k)};
      particles().spin[i] = 100.0 * std::sin(2.3 * k);
    }
    charge();
  }
};

TEST(Lift, GivesTheGasWhatItTakesFromParticles) {
  StirredBed bed;
  Vec2 sum;
  double size = 0.0;
  for (const Vec2 f : bed.act()) sum += f, size += norm(f);
  EXPECT_GT(norm(sum), 1e-4 * size);
  EXPECT_LT(norm(sum + bed.onGas()), 1e-13 * size);
}

TEST(Lift, DoesNotDependOnThreads) {
  StirredBed one(1), three(3);
  ASSERT_GT(one.particles().size(), 5000u);  // several blocks
  EXPECT_EQ(one.gas->exchange().source, three.gas->exchange().source);
  EXPECT_EQ(one.act(), three.act());
}

/// A spinning sphere slows down in still water: v = v_0 e^(-t/tau) turned by the angle c, dc/dt = 3/4
/// rho/rho_p s, ds/dt = -60 mu/(rho_p d^2) s. Whatever the drag, it has turned by s_0 rho d^2/(80 mu) in the
/// end.
TEST(Lift, SpinningSphereTurnsByAnEightiethOfItsSpinsReynoldsNumber) {
  Scene scene = waterScene();
  scene.bed = {0.048, 0.12, 0.048};
  scene.particles.diameter = 1e-3;
  scene.gas->step = 1e-4;
  const double spin = 20.0, reynolds = 1000.0 * 1e-6 * spin / 1e-3;  // 20, and Re < 1
  Particles start = makeParticles(scene, {{0.024, 0.06}});
  start.velocity[0] = {8e-4, 0.0};
  start.spin[0] = spin;
  const auto turned = [&](double step) {
    scene.gas->step = step;
    Simulation simulation = Simulation::make(scene, start);
    EXPECT_FALSE(simulation.advance(stepsPerGasStep(scene) * std::llround(0.1 / step)));
    const FramePtr frame = simulation.frame();
    const double k = 60.0 * 1e-3 / (2500.0 * 1e-6);  // 1/s
    EXPECT_NEAR(static_cast<double>(frame->angularVelocity[0]) / (spin * std::exp(-k * 0.1)), 1.0,
                0.6 * k * 0.1 * k * step);
    const Vec2f v = frame->velocity[0];
    return std::atan2(static_cast<double>(v.y), static_cast<double>(v.x)) / (1.0 - std::exp(-k * 0.1));
  };
  EXPECT_NEAR(turned(1e-4) / (reynolds / 80.0), 1.0, 0.01);
}

std::vector<Contradiction> brokenBy(const LiftSettings& lift, bool gas, bool friction) {
  Scene scene = lowScene(20, 1.0);
  if (!gas) scene.gas.reset();
  if (!friction) scene.contacts.friction.reset();
  scene.effects.at<LiftSettings>() = lift;
  return contradictions(scene);
}

TEST(Lift, ContradictionsAreNamed) {
  EXPECT_TRUE(brokenBy({}, true, true).empty());
  EXPECT_TRUE(brokenBy(byShear, true, false).empty());
  EXPECT_EQ(brokenBy({}, false, true).at(0).path, "lift");
  EXPECT_EQ(brokenBy({}, true, false).at(0).path, "lift.spin");
  EXPECT_EQ(brokenBy({ShearLift::none, SpinLift::none}, true, true).at(0).path, "lift.shear");
}

TEST(Lift, BreaksChangeNothing) {
  Scene scene = lowScene(300, 2.0);
  scene.effects.at<LiftSettings>().emplace();
  Simulation whole = simulate(scene), half = simulate(scene);
  ASSERT_FALSE(whole.advance(1000) || half.advance(505));
  StateWriter out(0);
  half.save(out);
  const std::vector<std::byte> bytes = out.take();
  StateReader in(bytes);
  std::optional<Simulation> rest = Simulation::make(scene, in, 2);
  ASSERT_TRUE(rest && in.done());
  ASSERT_FALSE(rest->advance(495));
  EXPECT_EQ(whole.stateHash(), rest->stateHash());
  scene.effects.at<LiftSettings>().reset();
  Simulation plain = simulate(scene);
  ASSERT_FALSE(plain.advance(1000));
  EXPECT_NE(whole.stateHash(), plain.stateHash());
}

}  // namespace
}  // namespace bedmix::test
