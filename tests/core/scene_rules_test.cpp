// SPDX-License-Identifier: MIT
#include "tests/core/spoiled_scene.h"

#include <gtest/gtest.h>

namespace bedmix {
namespace {

/// A scene without contradictions, to be spoiled by each test in one way.
Scene soundScene() {
  Scene s;
  s.bed = {0.048, 0.12, 0.004, BedTop::open};
  s.particles = {60, 0.004, 1500.0};
  s.contacts.restitution = 0.9;
  s.time = {0.05, 1e-5, Integrator::velocityVerlet};
  s.gas.emplace();
  s.gas->grid = {{{4, 0.012}}, {{10, 0.012}}};
  s.gas->inlets = {{0.0, 0.024, {}, 2.0}, {0.024, 0.048, 1.5, {}}};
  s.flux = FluxSettings{0.024, 0.0, 0.04};
  return s;
}

using test::Spoiled;

class Rule : public ::testing::TestWithParam<Spoiled> {};

TEST(Rules, SoundSceneBreaksNone) { EXPECT_TRUE(contradictions(soundScene()).empty()); }

TEST_P(Rule, IsReportedOnceWithItsReason) { test::expectReportedOnce(soundScene(), GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Scene, Rule,
    ::testing::Values(
        Spoiled{"BothDampings", [](Scene& s) { s.contacts.damping = 0.17; }, "contacts.damping", "keep one"},
        Spoiled{"NoDamping", [](Scene& s) { s.contacts.restitution.reset(); }, "contacts.restitution",
                "either restitution"},
        Spoiled{"ThinBed", [](Scene& s) { s.bed.thickness = 0.003; }, "bed.thickness", "at least a diameter"},
        Spoiled{"NarrowBed",
                [](Scene& s) {
                  s.bed.width = 0.003;
                  s.gas.reset();
                  s.flux.reset();
                },
                "bed.width", "narrower than a particle"},
        Spoiled{"EndlessBed",
                [](Scene& s) {
                  s.bed.width = 1e308;
                  s.gas.reset();
                },
                "bed.width", "inf particle diameters"},
        Spoiled{"SteepFloor",
                [](Scene& s) {
                  s.floor.inclinationDeg = 60.0;
                  s.bed.height = 0.084;
                  s.gas.reset();
                  s.flux.reset();
                },
                "floor.inclination_deg", "no room"},
        Spoiled{"StairWithoutGas",
                [](Scene& s) {
                  s.floor = {10.0, FloorShape::stair};
                  s.gas.reset();
                },
                "floor.shape", "no [gas]"},
        Spoiled{"FullLid",
                [](Scene& s) {
                  s.bed.top = BedTop::lid;
                  s.particles.count = 1000;
                },
                "particles.count", "closest packing holds 415"},
        Spoiled{"NarrowPeriodicBed",
                [](Scene& s) {
                  s.bed.sides = BedSides::periodic;
                  s.bed.width = 0.016;
                  s.gas.reset();
                  s.flux.reset();
                },
                "bed.width", "wider than 5 diameters"},
        Spoiled{"InclinedPeriodicBed",
                [](Scene& s) {
                  s.bed.sides = BedSides::periodic;
                  s.floor.inclinationDeg = 5.0;
                },
                "floor.inclination_deg", "would jump"},
        Spoiled{"ObstacleAtPeriodicSide",
                [](Scene& s) {
                  s.bed.sides = BedSides::periodic;
                  s.obstacles.push_back({.x = 0.012, .y = 0.06, .radius = 0.006});
                },
                "obstacles.0", "must stay 0.008 m"},
        Spoiled{"DrumBetweenPeriodicSides",
                [](Scene& s) {
                  s.bed.sides = BedSides::periodic;
                  s.gas.reset();
                  s.flux.reset();
                  s.obstacles.push_back(
                      {.shape = ObstacleShape::drum, .x = 0.024, .y = 0.06, .radius = 0.024});
                },
                "obstacles.0.shape", "a drum holds all"},
        Spoiled{"FewPeriodicColumns",
                [](Scene& s) {
                  s.bed.sides = BedSides::periodic;
                  s.gas->grid.columns = {{3, 0.016}};
                },
                "gas.grid.columns", "4 columns of gas cells at least"},
        Spoiled{"UnlikePeriodicColumns",
                [](Scene& s) {
                  s.bed.sides = BedSides::periodic;
                  s.gas->grid.columns = {{2, 0.008}, {2, 0.016}};
                },
                "gas.grid.columns", "as wide as each other"},
        Spoiled{"LongStep", [](Scene& s) { s.time.step = 1e-4; }, "time.step", "T/9.96"},
        Spoiled{"Duration", [](Scene& s) { s.time.duration = 0.050004; }, "time.duration",
                "the nearest is 0.05 s"},
        Spoiled{"Interval", [](Scene& s) { s.sampling.interval = 0.010006; }, "sampling.interval",
                "the nearest is 0.01001 s"},
        Spoiled{"GasStep", [](Scene& s) { s.gas->step = 2.5e-5; }, "gas.step", "must be a whole number"},
        Spoiled{"GasStepBelow", [](Scene& s) { s.gas->step = 1e-6; }, "gas.step", "the nearest is 1e-05 s"},
        Spoiled{"GasStepBeyondRelaxation",
                [](Scene& s) {
                  s.gas->viscosity = 0.01;  // 2 x 0.4^3 density d^2/(150 x 0.6 viscosity) = 3.41 ms
                  s.gas->step = 3.5e-3;
                },
                "gas.step", "Take at most 0.00341 s"},
        Spoiled{"TooLightForTheGas",
                [](Scene& s) {
                  s.gas->density = 2001.0;
                  s.gas->minimumFluidizationVelocity = 1.0;
                },
                "particles.density", "Give at least 1501 kg/m3"},
        Spoiled{"Endless", [](Scene& s) { s.time.duration = 1e12; }, "time.duration", "at most 1e+15"},
        Spoiled{"CutShort",
                [](Scene& s) {
                  s.time.step = s.gas->step = StepLength::automatic();
                  s.time.duration = 0.045;
                },
                "time.duration", "the nearest is 0.05 s"},
        Spoiled{"GasStepBesideChosenSteps",
                [](Scene& s) {
                  s.time.step = StepLength::automatic();
                  s.gas->step = 3e-4;
                  s.time.duration = 0.06;
                },
                "sampling.interval", "steps of 0.0003 s"},
        Spoiled{"ChosenStepsOfEuler",
                [](Scene& s) {
                  s.time.step = s.gas->step = StepLength::automatic();
                  s.time.integrator = Integrator::symplecticEuler;
                },
                "time.integrator", "errors cancel"},
        Spoiled{"EndlessChosenSteps",
                [](Scene& s) {
                  s.time.step = s.gas->step = StepLength::automatic();
                  s.time.duration = 1e12;
                },
                "time.duration", "at most 1e+15"},
        Spoiled{"Columns", [](Scene& s) { s.gas->grid.columns[0].count = 5; }, "gas.grid.columns",
                "add up to 0.06 m, but bed.width is 0.048 m"},
        Spoiled{"CellsSmallerThanParticles",
                [](Scene& s) {
                  s.gas->grid.columns = {{16, 0.003}};
                },
                "gas.grid.columns", "smaller than a particle (0.004 m)"},
        Spoiled{"Rows", [](Scene& s) { s.gas->grid.rows[0].size = 0.011; }, "gas.grid.rows", "0.11 m"},
        Spoiled{"EmptyInlet", [](Scene& s) { s.gas->inlets[0].from = 0.024; }, "gas.inlets.0.to", "right of"},
        Spoiled{"OutsideInlet", [](Scene& s) { s.gas->inlets[1].to = 0.05; }, "gas.inlets.1.to", "outside"},
        Spoiled{"OverlappingInlet", [](Scene& s) { s.gas->inlets[1].from = 0.02; }, "gas.inlets.1",
                "overlaps"},
        Spoiled{"TwoVelocities", [](Scene& s) { s.gas->inlets[0].velocity = 1.0; },
                "gas.inlets.0.velocity_umf", "keep one"},
        Spoiled{"NoVelocity", [](Scene& s) { s.gas->inlets[1].velocity.reset(); }, "gas.inlets.1.velocity",
                "either velocity"},
        Spoiled{"NoUmf", [](Scene& s) { s.gravity = 0.0; }, "gas.inlets.0.velocity_umf", "do not sink"},
        Spoiled{"FlatWindow", [](Scene& s) { s.flux->from = 0.04; }, "flux.to", "not above"},
        Spoiled{"WindowAtWall", [](Scene& s) { s.flux->x = 0.047; }, "flux.x", "leaves the bed"},
        Spoiled{"HighWindow", [](Scene& s) { s.flux->to = 0.13; }, "flux.to", "above the bed's"},
        Spoiled{"GasLayerWithoutGas",
                [](Scene& s) {
                  s.gas.reset();
                  s.flux.reset();
                  s.pictures.emplace().layers = {Layer::particles, Layer::streamlines};
                },
                "pictures.layers", "'streamlines' shows the gas"},
        Spoiled{"TwoFields",
                [](Scene& s) {
                  s.pictures.emplace().layers = {Layer::gasSpeed, Layer::pressure};
                },
                "pictures.layers", "'pressure' and 'gas-speed' colour the same cells"},
        Spoiled{"SpinWithoutFriction",
                [](Scene& s) { s.pictures.emplace().color = ParticleColor::spin; }, "pictures.color",
                "no [contacts.friction]"},
        Spoiled{"VoidageColorWithoutGas",
                [](Scene& s) {
                  s.gas.reset();
                  s.flux.reset();
                  s.pictures.emplace().color = ParticleColor::voidage;
                },
                "pictures.color", "needs the gas"},
        Spoiled{"TrailOfNobody",
                [](Scene& s) {
                  s.pictures.emplace().trails = {59, 60};
                },
                "pictures.trails", "no particle 60"},
        Spoiled{"TrailsOfNone",
                [](Scene& s) {
                  s.pictures.emplace().layers = {Layer::trails};
                },
                "pictures.layers", "give their numbers"},
        Spoiled{"ScheduleThatGoesBack",
                [](Scene& s) {
                  s.gas->inlets[0].schedule = {{0.0, 1.0}, {0.2, 0.5}, {0.1, 1.0}};
                },
                "gas.inlets.0.schedule.2.time", "follow each other"},
        Spoiled{"PulseWithinAStep",
                [](Scene& s) { s.gas->inlets[1].pulse = PulseSettings{.frequency = 0.2 / s.gas->step}; },
                "gas.inlets.1.pulse.frequency", "at most a tenth"},
        Spoiled{"Limits", [](Scene& s) { s.limits.warnOverlap = 0.2; }, "limits.warn_overlap", "above"}),
    test::nameOfSpoiled);

TEST(Rules, ChosenStepsFitAnyInterval) {
  Scene scene = soundScene();
  scene.time.step = scene.gas->step = StepLength::automatic();
  scene.sampling.interval = 0.0123;
  scene.time.duration = 0.123;
  EXPECT_TRUE(contradictions(scene).empty());
}

TEST(Rules, SlowestAllowedStepIsAFourteenthOfTheTimeScale) {
  Scene scene = soundScene();
  scene.gas.reset();
  scene.sampling.interval = scene.time.step = contactTimeScale(scene) / 14.0;
  scene.time.duration = scene.time.step * 10.0;
  EXPECT_TRUE(contradictions(scene).empty());
  scene.time.step = scene.sampling.interval = contactTimeScale(scene) / 13.9;
  scene.time.duration = scene.time.step * 10.0;
  EXPECT_EQ(contradictions(scene).size(), 1u);
}

}  // namespace
}  // namespace bedmix
