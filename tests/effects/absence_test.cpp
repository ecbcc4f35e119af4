// SPDX-License-Identifier: MIT
#include "engine/core/scene_reader.h"
#include "engine/effects/advice.h"
#include "engine/effects/effects.h"
#include "engine/simulation.h"
#include "replay/hdf5_input.h"
#include "replay/trajectory_layout.h"
#include "replay/trajectory_writer.h"
#include "tests/gas/gas_scenes.h"
#include "tests/render/temp_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <numbers>
#include <sstream>

namespace bedmix {
namespace {

Scene bundled(const std::string& name) {
  std::ifstream file(BEDMIX_SOURCE_DIR "/assets/scenes/" + name + ".toml");
  std::ostringstream text;
  text << file.rdbuf();
  return std::move(readScene(text.str(), name).value).value();
}

/// What a running bed keeps, in bytes.
std::size_t stateBytes(const Scene& scene) {
  const Simulation simulation = test::simulate(scene);
  StateWriter out(0);
  simulation.save(out);
  return out.take().size();
}

Scene plainScene(std::int64_t particles) {
  Scene scene = test::lowScene(particles, 1.0);
  scene.gas.reset();
  scene.contacts.friction.reset();
  scene.start.arrangement = Arrangement::drop;
  return scene;
}

/// A bed without effects keeps a place, a velocity, an id, a tag and the load of the step for each particle,
/// and no array of an effect; with one, it keeps that.
TEST(Absence, KeepsNothingOfEffectsThatAreOff) {
  const auto perParticle = [](const auto& change) {
    Scene few = plainScene(20), many = plainScene(60);
    change(few);
    change(many);
    return static_cast<double>(stateBytes(many) - stateBytes(few)) / 40.0;
  };
  const double plain = perParticle([](Scene&) {});
  EXPECT_EQ(plain, 16.0 + 16.0 + 4.0 + 4.0 + 1.0);  // position, velocity, id twice, tag
  EXPECT_EQ(perParticle([](Scene& s) { s.contacts.friction.emplace(); }), plain + 8.0);  // spin
  const auto gas = [](Scene& s) { s.gas = test::lowScene(1, 1.0).gas; };
  EXPECT_EQ(perParticle(gas), plain + 16.0 + 8.0 + 16.0);  // force, drag, where it was foreseen
  EXPECT_EQ(perParticle([](Scene& s) { s.effects.at<HeatSettings>().emplace().heatCapacity = 840.0; }),
            plain + 8.0);  // temperature
  // Of a feed both beds have room for as many.
  EXPECT_EQ(perParticle([](Scene& s) {
              FeedSettings& feed = s.effects.at<FeedSettings>().emplace();
              feed.most = 100;
              feed.outlets = {{0.0, 0.01, 0.0, 0.01}};
            }),
            plain);
  // Lift is made anew of what there is; virtual mass remembers itself, a velocity and a force.
  EXPECT_EQ(perParticle([&](Scene& s) {
              gas(s);
              s.effects.at<LiftSettings>() = {ShearLift::mei, SpinLift::none};
            }),
            perParticle(gas));
  EXPECT_EQ(perParticle([&](Scene& s) {
              gas(s);
              s.effects.at<VirtualMassSettings>().emplace();
            }),
            perParticle(gas) + 8.0 + 16.0 + 16.0);
  // Contacts that differ have no state of their own.
  EXPECT_EQ(perParticle([](Scene& s) {
              s.contacts.hertz.emplace();
              s.contacts.stiffness.reset();
            }),
            plain);
  EXPECT_EQ(perParticle([](Scene& s) {
              s.particles.size.emplace();
              s.bed.thickness = 0.008;
            }),
            plain);
}

TEST(Absence, FramesAndFilesHaveNoColumnsOfEffectsThatAreOff) {
  const test::TempFolder folder;
  struct Case {
    const char* column;
    void (*turnOn)(Scene&);
  };
  const Case cases[] = {
      {layout::angularVelocity, [](Scene& s) { s.contacts.friction.emplace(); }},
      {layout::gas, [](Scene& s) { s.gas = test::lowScene(1, 1.0).gas; }},
      {layout::temperature, [](Scene& s) { s.effects.at<HeatSettings>().emplace().heatCapacity = 840.0; }},
      {layout::radius,
       [](Scene& s) {
         s.particles.size.emplace();
         s.bed.thickness = 0.008;
       }},
      {layout::kind,
       [](Scene& s) {
         s.particles.species.push_back({"other", 3, {}, {}, {}});
       }},
  };
  const auto columnsOf = [&](const Scene& scene) {
    const auto path = folder / "trajectory.h5";
    std::filesystem::remove(path);
    {
      auto writer = TrajectoryWriter::create(path, scene, {});
      writer->accept(*test::simulate(scene).frame());
      EXPECT_FALSE(writer->failure());
    }
    const Hdf5Input in(path, Reading::whole);
    std::vector<bool> has;
    for (const Case& c : cases) has.push_back(in.has(c.column));
    return has;
  };
  const std::size_t count = std::size(cases);
  EXPECT_EQ(columnsOf(plainScene(20)), std::vector<bool>(count, false));
  for (std::size_t c = 0; c < count; ++c) {
    Scene scene = plainScene(20);
    cases[c].turnOn(scene);
    EXPECT_TRUE(columnsOf(scene)[c]) << cases[c].column;
  }
  const FramePtr frame = test::simulate(plainScene(20)).frame();
  EXPECT_FALSE(frame->hasGas());
  EXPECT_TRUE(frame->angularVelocity.empty() && frame->temperature.empty() && frame->radius.empty() &&
              frame->kind.empty());
}

/// The paper's case A to the bit, on any machine: no effect that is added to the program may change it. Where
/// it changes because the model does, CHANGELOG.md says why.
TEST(Absence, CaseAStaysWhatItIs) {
  Simulation simulation = test::simulate(bundled("tian-2007-even"));
  ASSERT_EQ(simulation.advance(5000), std::nullopt);
  EXPECT_EQ(simulation.stateHash(), 0x9ec8746df55ff00du);
}

TEST(EffectTable, IsOnWhereItsTableIs) {
  const Scene plain = plainScene(20);
  for (const EffectInfo& effect : effectTable()) {
    EXPECT_FALSE(effect.isOn(plain)) << effect.table;
    EXPECT_FALSE(effect.note(plain).empty()) << effect.table;
  }
  const Scene even = bundled("tian-2007-even");
  for (const EffectInfo& effect : effectTable())
    EXPECT_EQ(effect.isOn(even), effect.table == "gas" || effect.table == "contacts.friction")
        << effect.table;
}

const EffectAdvice& adviceOn(const std::vector<EffectAdvice>& all, std::string_view table) {
  return *std::find_if(all.begin(), all.end(), [&](const EffectAdvice& a) { return a.table == table; });
}

TEST(Advice, TellsFineGrainsToStickAndPebblesNot) {
  Scene scene = plainScene(20);
  scene.particles.density = 2500.0;
  scene.particles.diameter = 0.003;
  EXPECT_FALSE(adviceOn(effectAdvice(scene), "cohesion").matters);
  scene.particles.diameter = 50e-6;
  EXPECT_TRUE(adviceOn(effectAdvice(scene), "cohesion").matters);
  // Bo = A r/(12 z^2) / (m g)
  const double pull = 1e-19 * 1e-7 / (12.0 * 16e-20);
  EXPECT_NEAR(adviceOn(effectAdvice(scene), "cohesion").value, pull / (particleMass(scene) * 9.81), 1e-9);
}

TEST(Advice, TellsDustThatItsFallNeedsTheAir) {
  Scene scene = plainScene(20);
  scene.particles.diameter = 0.01;
  EXPECT_FALSE(adviceOn(effectAdvice(scene), "gas").matters);
  scene.particles.diameter = 1e-4;
  EXPECT_TRUE(adviceOn(effectAdvice(scene), "gas").matters);
  Scene still = test::lowScene(20, 1e-4);
  EXPECT_FALSE(adviceOn(effectAdvice(still), "gas").matters);
  EXPECT_TRUE(adviceOn(effectAdvice(test::lowScene(20, 2.0)), "gas").matters);
}

TEST(Advice, TellsWhatLiquidsDoThatGasesDoNot) {
  Scene scene = test::lowScene(20, 0.1);
  const auto of = [&](std::string_view table) { return adviceOn(effectAdvice(scene), table); };
  EXPECT_FALSE(of("virtual_mass").matters);
  EXPECT_FALSE(of("virtual_mass").isOn);
  scene.effects.at<VirtualMassSettings>().emplace();
  scene.effects.at<LiftSettings>().emplace();
  scene.gas->density = 1000.0;
  scene.gas->viscosity = 1e-3;
  EXPECT_NEAR(of("virtual_mass").value, 0.5 * 1000.0 / 1500.0, 1e-12);
  EXPECT_TRUE(of("virtual_mass").matters && of("virtual_mass").isOn && of("lift").isOn);
  // Saffman over Stokes, 1.615/(3 pi) sqrt(d^2 G/nu), with G = u/(cell), at Re = 0.04
  scene.gas->viscosity = 10.0;
  EXPECT_NEAR(of("lift").value, 1.615 / (3.0 * std::numbers::pi) * std::sqrt(16e-6 * 0.1 / 0.012 / 0.01),
              0.02 * of("lift").value);
  EXPECT_FALSE(of("lift").matters);
  scene.gas.reset();
  const std::vector<EffectAdvice> without = effectAdvice(scene);
  EXPECT_TRUE(
      std::none_of(without.begin(), without.end(), [](const EffectAdvice& a) { return a.table == "lift"; }));
}

}  // namespace
}  // namespace bedmix
