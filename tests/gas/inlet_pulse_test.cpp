// SPDX-License-Identifier: MIT
#include "engine/checkpoint.h"
#include "engine/core/bed_statistics.h"
#include "engine/core/inlet_flow.h"
#include "tests/gas/gas_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bedmix {
namespace {

constexpr double velocity = 1.5;

Scene emptyBed(const PulseSettings& pulse) {
  Scene scene = test::lowScene(0, velocity);
  scene.gas->inlets[0].pulse = pulse;
  return scene;
}

/// Superficial velocity through the open top, m/s, of a frame's gas: of an empty bed with slip at no place
/// but the side walls, the mean of the uppermost cells.
double throughTop(const Simulation& simulation, const GasGrid& grid) {
  const FramePtr frame = simulation.frame();
  double sum = 0.0;
  for (int c = 0; c < grid.columns; ++c) sum += frame->gas.velocity[grid.cell(c, grid.rows - 1)].y;
  return sum / grid.columns;
}

TEST(InletPulse, SineIsThatOfTheLibrary) {
  for (const double t : {0.0, 0.013, 0.11, 0.24, 0.3701, 1.9, 77.7}) {
    const PulseSettings pulse{PulseShape::sine, 3.0, 0.7, 0.5, 0.2};
    const double argument = 2.0 * std::numbers::pi * (3.0 * t + 0.2);
    EXPECT_NEAR(meanOf(pulse, t, 1e-12), 1.0 + 0.7 * std::sin(argument), 1e-10);
    const double end = argument + 2.0 * std::numbers::pi * 3.0 * 0.05;
    EXPECT_NEAR(meanOf(pulse, t, 0.05),
                1.0 + 0.7 * (std::cos(argument) - std::cos(end)) / (2.0 * std::numbers::pi * 3.0 * 0.05),
                1e-12);
  }
}

TEST(InletPulse, SquareIsOnForItsDutyAndMeansOne) {
  const PulseSettings pulse{PulseShape::square, 5.0, 1.0, 0.25, 0.0};
  EXPECT_NEAR(meanOf(pulse, 0.01, 0.001), 4.0, 1e-9);
  EXPECT_NEAR(meanOf(pulse, 0.06, 0.001), 0.0, 1e-9);
  EXPECT_NEAR(meanOf(pulse, 0.049, 0.002), 2.0, 1e-9);  // half of it on
  EXPECT_NEAR(meanOf(pulse, 0.0, 0.2), 1.0, 1e-12);
  const PulseSettings shallow{PulseShape::square, 5.0, 0.5, 0.25, 0.0};
  EXPECT_NEAR(meanOf(shallow, 0.01, 0.001), 2.5, 1e-9);
  EXPECT_NEAR(meanOf(shallow, 0.06, 0.001), 0.5, 1e-9);
}

TEST(InletPulse, WhatGoesThroughTheBedFollowsItAndMeansTheInletsVelocity) {
  for (const PulseShape shape : {PulseShape::sine, PulseShape::square}) {
    const PulseSettings pulse{shape, 5.0, 0.8, 0.3, 0.1};
    const Scene scene = emptyBed(pulse);
    const GasGrid grid = makeGasGrid(scene);
    Simulation simulation = test::simulate(scene);
    const double gasStep = scene.gas->step;
    double mean = 0.0;
    const int steps = 2000;  // one period of 0.2 s
    for (int k = 0; k < steps; ++k) {
      ASSERT_EQ(simulation.advance(10), std::nullopt);
      const double through = throughTop(simulation, grid);
      ASSERT_NEAR(through, velocity * meanOf(pulse, simulation.time(), gasStep), 1e-6 * velocity)
          << simulation.time();
      mean += through / steps;
    }
    EXPECT_NEAR(mean / velocity, 1.0, 1e-6);
    EXPECT_LT(simulation.report().largestMassResidual, 1e-10);
  }
}

TEST(InletPulse, ScheduleIsLinearBetweenItsPoints) {
  Scene scene = test::lowScene(0, velocity);
  scene.gas->inlets[0].schedule = {{0.05, 0.0}, {0.15, 2.0}};
  EXPECT_EQ(fastestInlet(scene), 2.0 * velocity);
  InletFlow flow(scene, makeGasGrid(scene));
  EXPECT_EQ(flow.over(0.0, 0.01)[0], 0.0);
  EXPECT_NEAR(flow.over(0.07, 0.02)[2], 0.6 * velocity, 1e-12);
  EXPECT_NEAR(flow.over(0.3, 0.1)[3], 2.0 * velocity, 1e-12);
}

TEST(InletPulse, OtherInletsAreWhatTheyWere) {
  Scene scene = test::lowScene(0, velocity);
  scene.gas->inlets = {{0.0, 0.030, 1.0, std::nullopt}, {0.030, 0.048, 2.0, std::nullopt}};
  scene.gas->inlets[1].pulse = PulseSettings{PulseShape::sine, 2.0, 1.0, 0.5, 0.75};  // at its lowest
  const GasGrid grid = makeGasGrid(scene);
  InletFlow flow(scene, grid);
  const std::vector<double>& flux = flow.over(0.0, 1e-9);
  EXPECT_NEAR(flux[0], 1.0, 1e-12);
  EXPECT_NEAR(flux[2], 0.5, 1e-9);  // half of the column is the first inlet's
  EXPECT_NEAR(flux[3], 0.0, 1e-9);
}

TEST(InletPulse, ChosenStepsForeseeIt) {
  Scene scene = emptyBed({PulseShape::square, 4.0, 1.0, 0.1, 0.5});  // off at first, then ten times as fast
  scene.time.step = scene.gas->step = StepLength::automatic();
  ASSERT_NEAR(fastestInlet(scene), 10.0 * velocity, 1e-12);
  Simulation simulation = test::simulate(scene);
  ASSERT_EQ(simulation.advance(20 * stepsPerFrame(scene)), std::nullopt);
  EXPECT_LT(simulation.report().largestCourant,
            0.7);  // the aim is 0.5; the wall's layer makes the core faster
  EXPECT_GT(simulation.report().largestCourant, 0.1);
}

TEST(ResumePulse, GoesOnToTheBitInPhase) {
  for (const bool automatic : {false, true}) {
    Scene scene = test::lowScene(60, 3.0);
    scene.gas->inlets[0].pulse = PulseSettings{PulseShape::sine, 7.0, 0.9, 0.5, 0.3};
    if (automatic) scene.time.step = scene.gas->step = StepLength::automatic();
    Simulation whole = test::simulate(scene);
    ASSERT_EQ(whole.advance(3 * stepsPerFrame(scene)), std::nullopt);
    auto resumed = readCheckpoint(writeCheckpoint(whole, scene, 0.0), scene, 1);
    ASSERT_TRUE(resumed);
    ASSERT_EQ(whole.advance(4 * stepsPerFrame(scene)), std::nullopt);
    ASSERT_EQ(resumed->simulation.advance(4 * stepsPerFrame(scene)), std::nullopt);
    EXPECT_EQ(resumed->simulation.stateHash(), whole.stateHash());
  }
}

TEST(ResumePulse, ItMattersWhenItBegins) {
  Scene scene = test::lowScene(60, 3.0), later = scene;
  scene.gas->inlets[0].pulse = PulseSettings{PulseShape::sine, 7.0, 0.9, 0.5, 0.3};
  later.gas->inlets[0].pulse = PulseSettings{PulseShape::sine, 7.0, 0.9, 0.5, 0.4};
  Simulation one = test::simulate(scene), other = test::simulate(later);
  ASSERT_EQ(one.advance(1000), std::nullopt);
  ASSERT_EQ(other.advance(1000), std::nullopt);
  EXPECT_NE(one.stateHash(), other.stateHash());
}

}  // namespace
}  // namespace bedmix
