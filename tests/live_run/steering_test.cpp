// SPDX-License-Identifier: MIT
#include "engine/core/steering.h"

#include "engine/core/scene_keys.h"
#include "engine/simulation.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace bedmix {
namespace {

/// A bed with all effects that blows from the beginning.
Scene steeredBed() {
  Scene scene = test::lowScene(60, 3.0);
  scene.name = "low";
  scene.start.arrangement = Arrangement::drop;
  scene.sampling.interval = 0.005;
  scene.flux = FluxSettings{.x = 0.02, .from = 0.0, .to = 0.05};
  scene.pictures.emplace();
  return scene;
}

Scene withChosenSteps(Scene scene) {
  scene.time.step = scene.gas->step = StepLength::automatic();
  scene.time.integrator = Integrator::verletOnset;
  return scene;
}

/// What a scene is changed by first for a key of an effect that the bed has not.
std::vector<Override> turningOn(const std::string& key) {
  if (key.starts_with("contacts.hertz"))
    return {{"contacts.stiffness", ""}, {"contacts.hertz", "{youngs_modulus = 2e6}"}};
  if (key.starts_with("contacts.rolling")) return {{"contacts.rolling", "{}"}};
  if (key.starts_with("contacts.pairs")) return {{"contacts.pairs", "[{first = 'first', second = 'wall'}]"}};
  if (key.starts_with("cohesion.van_der_waals"))
    return {{"cohesion", "{van_der_waals = {hamaker = 1e-18, cutoff = 1e-5}}"}};
  if (key.starts_with("cohesion.liquid_bridge"))
    return {{"cohesion", "{liquid_bridge = {surface_tension = 0.01}}"}};
  if (key.starts_with("heat")) return {{"heat", "{heat_capacity = 840.0, conductivity = 1.0, gas = {}}"}};
  if (key.starts_with("feed")) {
    std::vector<Override> changes{{"feed",
                                   "{most = 200, streams = [{rate = 500.0, from = 0.0, to = 0.03, y = 0.1}], "
                                   "outlets = [{from = 0.04, to = 0.048, bottom = 0.0, top = 0.05}]}"}};
    if (key.ends_with("temperature"))
      changes.push_back({"heat", "{heat_capacity = 840.0, conductivity = 1.0, gas = {}}"});
    return changes;
  }
  if (key.starts_with("reaction"))
    return {{"reaction", "{rate = 0.5}"}, {"heat", "{heat_capacity = 840.0, conductivity = 1.0, gas = {}}"}};
  if (key.starts_with("lift")) return {{"lift", "{}"}};
  if (key.starts_with("virtual_mass")) return {{"virtual_mass", "{}"}};
  if (key.starts_with("gas.inlets.pulse")) {
    const char* shape = key.ends_with("duty") ? "square" : "sine";
    return {
        {"gas.inlets.0.pulse", std::string("{frequency = 20.0, amplitude = 0.5, shape = '") + shape + "'}"}};
  }
  if (key.starts_with("gas.inlets.schedule"))
    return {{"gas.inlets.0.schedule", "[{time = 0.0, factor = 1.0}, {time = 1.0, factor = 1.1}]"}};
  if (key.starts_with("cohesion.sjkr")) return {{"cohesion", "{sjkr = {energy_density = 1e3}}"}};
  return {};
}
Scene withEffectOf(const std::string& key, const Scene& scene) {
  Result<Scene> with = readScene(writeScene(scene), "", turningOn(key));
  EXPECT_TRUE(with) << key << ": " << toString(with.problems.front());
  with->name = scene.name;
  return *with;
}

/// Another value for each key that may change.
const std::map<std::string, std::vector<Override>> otherValues{
    {"title", {{"title", "'another'"}}},
    {"gravity", {{"gravity", "8.0"}}},
    {"contacts.stiffness", {{"contacts.stiffness", "1500"}}},
    {"contacts.restitution", {{"contacts.restitution", "0.7"}}},
    {"contacts.damping", {{"contacts.restitution", ""}, {"contacts.damping", "0.05"}}},
    {"contacts.friction.coefficient", {{"contacts.friction.coefficient", "0"}}},
    {"contacts.friction.stiffness_ratio", {{"contacts.friction.stiffness_ratio", "0.5"}}},
    {"contacts.friction.damping_ratio", {{"contacts.friction.damping_ratio", "0.1"}}},
    {"contacts.hertz.youngs_modulus", {{"contacts.hertz.youngs_modulus", "1e6"}}},
    {"contacts.hertz.poisson_ratio", {{"contacts.hertz.poisson_ratio", "0.4"}}},
    {"contacts.rolling.coefficient", {{"contacts.rolling.coefficient", "0.2"}}},
    {"contacts.rolling.damping_ratio", {{"contacts.rolling.damping_ratio", "0.1"}}},
    {"contacts.pairs.restitution", {{"contacts.pairs.0.restitution", "0.5"}}},
    {"contacts.pairs.friction", {{"contacts.pairs.0.friction", "0.1"}}},
    {"cohesion.van_der_waals.hamaker", {{"cohesion.van_der_waals.hamaker", "2e-18"}}},
    {"cohesion.van_der_waals.least_gap", {{"cohesion.van_der_waals.least_gap", "1e-9"}}},
    {"cohesion.liquid_bridge.surface_tension", {{"cohesion.liquid_bridge.surface_tension", "0.02"}}},
    {"cohesion.sjkr.energy_density", {{"cohesion.sjkr.energy_density", "2e3"}}},
    {"heat.heat_capacity", {{"heat.heat_capacity", "500.0"}}},
    {"heat.conductivity", {{"heat.conductivity", "0.5"}}},
    {"heat.wall_temperature", {{"heat.wall_temperature", "350.0"}}},
    {"heat.youngs_modulus", {{"heat.youngs_modulus", "6e10"}}},
    {"heat.poisson_ratio", {{"heat.poisson_ratio", "0.3"}}},
    {"heat.gas.heat_capacity", {{"heat.gas.heat_capacity", "2000.0"}}},
    {"heat.gas.conductivity", {{"heat.gas.conductivity", "0.05"}}},
    {"heat.gas.temperature", {{"heat.gas.temperature", "400.0"}}},
    {"heat.gas.inlet_temperature", {{"heat.gas.inlet_temperature", "400.0"}}},
    {"feed.streams.rate", {{"feed.streams.0.rate", "200.0"}}},
    {"feed.streams.from", {{"feed.streams.0.from", "0.01"}}},
    {"feed.streams.to", {{"feed.streams.0.to", "0.02"}}},
    {"feed.streams.y", {{"feed.streams.0.y", "0.11"}}},
    {"feed.streams.vx", {{"feed.streams.0.vx", "0.1"}}},
    {"feed.streams.vy", {{"feed.streams.0.vy", "-0.1"}}},
    {"feed.streams.temperature", {{"feed.streams.0.temperature", "400.0"}}},
    {"feed.outlets.from", {{"feed.outlets.0.from", "0.03"}}},
    {"feed.outlets.to", {{"feed.outlets.0.to", "0.044"}}},
    {"feed.outlets.bottom", {{"feed.outlets.0.bottom", "0.01"}}},
    {"feed.outlets.top", {{"feed.outlets.0.top", "0.06"}}},
    {"reaction.model", {{"reaction.model", "constant-rate"}}},
    {"reaction.rate", {{"reaction.rate", "0.1"}}},
    {"reaction.activation_energy", {{"reaction.activation_energy", "40e3"}}},
    {"reaction.reference_temperature", {{"reaction.reference_temperature", "350.0"}}},
    {"reaction.heat", {{"reaction.heat", "-2.4e6"}}},
    {"lift.shear", {{"lift.shear", "saffman"}}},
    {"lift.spin", {{"lift.spin", "rubinow-keller"}}},
    {"virtual_mass.coefficient", {{"virtual_mass.coefficient", "0.6"}}},
    {"virtual_mass.crowding", {{"virtual_mass.crowding", "none"}}},
    {"gas.inlets.pulse.shape", {{"gas.inlets.0.pulse.shape", "square"}}},
    {"gas.inlets.pulse.frequency", {{"gas.inlets.0.pulse.frequency", "10.0"}}},
    {"gas.inlets.pulse.amplitude", {{"gas.inlets.0.pulse.amplitude", "0.2"}}},
    {"gas.inlets.pulse.duty", {{"gas.inlets.0.pulse.duty", "0.4"}}},
    {"gas.inlets.pulse.phase", {{"gas.inlets.0.pulse.phase", "0.5"}}},
    {"gas.inlets.schedule.time", {{"gas.inlets.0.schedule.1.time", "2.0"}}},
    {"gas.inlets.schedule.factor", {{"gas.inlets.0.schedule.1.factor", "0.9"}}},
    {"time.error", {{"time.error", "0.02"}}},
    {"gas.density", {{"gas.density", "2.0"}}},
    {"gas.viscosity", {{"gas.viscosity", "3e-5"}}},
    {"gas.error", {{"gas.error", "0.2"}}},
    {"gas.scheme", {{"gas.scheme", "simple"}}},
    {"gas.time_scheme", {{"gas.time_scheme", "implicit-euler"}}},
    {"gas.drag", {{"gas.drag", "wen-yu"}}},
    {"gas.tolerance", {{"gas.tolerance", "1e-4"}}},
    {"gas.max_iterations", {{"gas.max_iterations", "50"}}},
    {"gas.minimum_fluidization_velocity", {{"gas.minimum_fluidization_velocity", "1.1"}}},
    {"gas.inlets.from", {{"gas.inlets.0.from", "0.012"}}},
    {"gas.inlets.to", {{"gas.inlets.0.to", "0.036"}}},
    {"gas.inlets.velocity", {{"gas.inlets.0.velocity", "6.0"}}},
    {"gas.inlets.velocity_umf", {{"gas.inlets.0.velocity", ""}, {"gas.inlets.0.velocity_umf", "2.0"}}},
    {"sampling.columns", {{"sampling.columns", "2"}}},
    {"sampling.rows", {{"sampling.rows", "5"}}},
    {"sampling.min_particles", {{"sampling.min_particles", "3"}}},
    {"flux.x", {{"flux.x", "0.03"}}},
    {"flux.from", {{"flux.from", "0.01"}}},
    {"flux.to", {{"flux.to", "0.06"}}},
    {"limits.warn_overlap", {{"limits.warn_overlap", "0.02"}}},
    {"limits.max_overlap", {{"limits.max_overlap", "0.3"}}},
    {"pictures.layers", {{"pictures.layers", "['particles']"}}},
    {"pictures.color", {{"pictures.color", "speed"}}},
    {"pictures.classes", {{"pictures.classes", "5"}}},
    {"pictures.background", {{"pictures.background", "'black'"}}},
    {"pictures.bubble_voidage", {{"pictures.bubble_voidage", "0.7"}}},
    {"pictures.trails", {{"pictures.trails", "[1, 2]"}}},
    {"pictures.trail_time", {{"pictures.trail_time", "0.2"}}},
};

void expectRunsOn(const Scene& scene, const std::string& key, const std::vector<Override>& changes) {
  Simulation simulation = test::simulate(scene);
  ASSERT_EQ(simulation.advance(2 * stepsPerFrame(scene)), std::nullopt) << key;
  const Result<Scene> steered = steeredScene(scene, changes);
  ASSERT_TRUE(steered) << key << ": " << toString(steered.problems.front());
  EXPECT_NE(sceneSettings(*steered), sceneSettings(scene)) << key;
  EXPECT_EQ(tick(*steered), tick(scene)) << key;
  const FramePtr before = simulation.frame();
  ASSERT_TRUE(simulation.steer(*steered)) << key;
  EXPECT_EQ(simulation.frame()->position, before->position) << key;
  ASSERT_EQ(simulation.advance(2 * stepsPerFrame(*steered)), std::nullopt) << key;
  const FramePtr frame = simulation.frame();
  EXPECT_NEAR(frame->time, 4.0 * scene.sampling.interval, 1e-12) << key;
  for (const Vec2f at : frame->position) EXPECT_TRUE(std::isfinite(at.x) && std::isfinite(at.y)) << key;
}

TEST(Steering, EveryKeyEitherChangesOrHasAReason) {
  const Scene given = steeredBed(), chosen = withChosenSteps(steeredBed());
  for (const SceneKey& key : sceneKeys()) {
    if (key.type == "table" || key.type == "list of tables") continue;
    const auto other = otherValues.find(key.path);
    EXPECT_EQ(reasonFixed(key.path).empty(), other != otherValues.end()) << key.path;
    if (other == otherValues.end()) continue;
    expectRunsOn(withEffectOf(key.path, given), key.path, other->second);
    expectRunsOn(withEffectOf(key.path, chosen), key.path, other->second);
  }
}

std::string refusal(const Scene& scene, const std::vector<Override>& changes) {
  const Result<Scene> steered = steeredScene(scene, changes);
  return steered ? "" : toString(steered.problems.front());
}

TEST(Steering, FixedKeysAreRefusedWithTheReason) {
  const Scene scene = steeredBed();
  EXPECT_EQ(reasonFixed("gas.inlets.0.velocity"), "");
  EXPECT_EQ(reasonFixed("gas.inlets"), "");
  EXPECT_EQ(
      refusal(scene, {{"bed.width", "0.06"}}),
      "--set bed.width: bed.width is fixed while a run goes on: the walls and the cells of the gas have "
      "been built of it");
  EXPECT_EQ(refusal(scene, {{"sampling.interval", "0.02", "the slider"}}),
            "the slider: sampling.interval is fixed while a run goes on: frames fall on it");
  EXPECT_EQ(
      refusal(scene, {{"gas.grid.columns", "[[2, 0.024]]"}}),
      "--set gas.grid.columns: gas.grid.columns is fixed while a run goes on: the cells of the gas have "
      "been built of it");
}

TEST(Steering, WholeTablesMayHoldNothingFixedThatIsNew) {
  const Scene scene = steeredBed();
  EXPECT_EQ(refusal(scene, {{"sampling", "{columns = 3, interval = 0.005}"}}), "");
  EXPECT_EQ(refusal(scene, {{"sampling", "{columns = 3}"}}),
            "--set sampling: sampling.interval is fixed while a run goes on: frames fall on it");
  EXPECT_EQ(refusal(scene, {{"gas.inlets.0", "{from = 0, to = 0.02, velocity = 1}"}}), "");
  EXPECT_EQ(refusal(scene, {{"gas.inlets", "[]"}}),
            "--set gas.inlets: the number of inlets is fixed while a run goes on: there are 1, not 0");
}

TEST(Steering, EffectsAreNotSwitched) {
  Scene scene = steeredBed();
  EXPECT_EQ(refusal(scene, {{"gas", ""}}),
            "--set gas: [gas] is fixed while a run goes on: this one has gas, which is part of its state");
  EXPECT_NE(refusal(scene, {{"contacts.friction", ""}}), "");
  EXPECT_NE(refusal(scene, {{"contacts", "{stiffness = 2000, restitution = 0.9}"}}), "");
  scene.gas.reset();
  EXPECT_EQ(
      refusal(scene, {{"gas.density", "1.3"}}),
      "--set gas.density: [gas] is fixed while a run goes on: this one has no gas, which is part of its "
      "state");
  EXPECT_EQ(refusal(scene, {{"flux", ""}}), "");
  scene.flux.reset();
  EXPECT_EQ(refusal(scene, {{"flux.x", "0.02"}}), "");
}

TEST(Steering, ValuesAreCheckedAndLocatedAtTheChange) {
  const Scene scene = steeredBed();
  EXPECT_EQ(refusal(scene, {{"gravity", "-1"}}),
            "--set gravity: gravity is -1 m/s2; it must be at least 0 m/s2 (acceleration, downward)");
  EXPECT_EQ(refusal(scene, {{"gravty", "1"}}).find("--set gravty: unknown key \"gravty\""), 0u);
  // What contradicts it stands in no file that anyone could open.
  EXPECT_EQ(
      refusal(scene, {{"contacts.stiffness", "1e6"}}).find("--set contacts.stiffness: a step of 1e-05 s"),
      0u);
  EXPECT_EQ(refusal(scene, {{"contacts.stiffness", "1e6"}, {"gravity", "9"}}).find("a step of 1e-05 s"), 0u);
}

TEST(Steering, WhatIsNoKeyStays) {
  Scene scene = steeredBed();
  scene.refinement = {1, 1};
  const Result<Scene> steered = steeredScene(scene, {{"gravity", "8"}});
  ASSERT_TRUE(steered);
  EXPECT_EQ(steered->name, "low");
  EXPECT_EQ(steered->refinement, scene.refinement);
  EXPECT_EQ(steered->gravity, 8.0);
}

/// Stiffer contacts would be counted in shorter ticks; frames' numbers of steps must not jump.
TEST(Steering, ChosenTicksStay) {
  Scene scene = withChosenSteps(steeredBed());
  const std::vector<Override> stiffer{{"contacts.stiffness", "2e6"}};
  Scene anew = scene;
  anew.contacts.stiffness = 2e6;
  ASSERT_LT(tick(anew), tick(scene));
  expectRunsOn(scene, "stiffer", stiffer);
  const Result<Scene> once = steeredScene(scene, stiffer);
  const Result<Scene> back = steeredScene(*once, {{"contacts.stiffness", "500"}});
  EXPECT_EQ(tick(*back), tick(scene));
}

TEST(Steer, NothingChangesNothing) {
  for (const Scene& scene : {steeredBed(), withChosenSteps(steeredBed())}) {
    Simulation plain = test::simulate(scene), steered = test::simulate(scene, 2);
    const std::int64_t frame = stepsPerFrame(scene);
    for (int frames = 0; frames < 6; ++frames) {
      ASSERT_TRUE(steered.steer(*steeredScene(scene, {})));
      EXPECT_EQ(steered.stateHash(), plain.stateHash()) << frames;
      ASSERT_EQ(plain.advance(frame), std::nullopt);
      ASSERT_EQ(steered.advance(frame), std::nullopt);
    }
    EXPECT_EQ(steered.stateHash(), plain.stateHash());
    EXPECT_EQ(steered.particleSteps(), plain.particleSteps());
    EXPECT_EQ(steered.gasSteps(), plain.gasSteps());
    EXPECT_EQ(steered.contacts(), plain.contacts());
    EXPECT_EQ(steered.frame()->species, plain.frame()->species);
  }
}

TEST(Steer, InletsAloneAreTheSameAsSetInlets) {
  for (const Scene& scene : {steeredBed(), withChosenSteps(steeredBed())}) {
    Simulation set = test::simulate(scene), steered = test::simulate(scene), plain = test::simulate(scene);
    const std::int64_t frame = stepsPerFrame(scene);
    for (Simulation* s : {&set, &steered, &plain}) ASSERT_EQ(s->advance(3 * frame), std::nullopt);
    const Scene other = *steeredScene(scene, {{"gas.inlets.0.velocity", "6"}, {"gas.inlets.0.to", "0.024"}});
    set.setInlets(other.gas->inlets);
    ASSERT_TRUE(steered.steer(other));
    for (Simulation* s : {&set, &steered, &plain}) ASSERT_EQ(s->advance(3 * frame), std::nullopt);
    EXPECT_EQ(steered.stateHash(), set.stateHash());
    EXPECT_NE(steered.stateHash(), plain.stateHash());
  }
}

TEST(Steer, TracerIsChosenFromWhereParticlesAre) {
  Simulation simulation = test::simulate(steeredBed());
  ASSERT_EQ(simulation.advance(10 * stepsPerFrame(steeredBed())), std::nullopt);
  const std::uint64_t before = simulation.stateHash();
  simulation.setTracer(TracerRule::rightHalf);
  EXPECT_EQ(simulation.stateHash(), before);
  const FramePtr frame = simulation.frame();
  for (std::size_t i = 0; i < frame->size(); ++i)
    EXPECT_EQ(frame->species[i] == 1, frame->position[i].x >= 0.024f) << i;
}

}  // namespace
}  // namespace bedmix
