// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/key.h"
#include "engine/core/scene.h"

// The one description of every key a scene may hold: name, unit, range, meaning. The reader, the writer,
// --help and summary.json are all driven by it: a visitor is called once per key, in the order of the file.

namespace bedmix {

template <class V>
void describe(BedSettings& s, V& visit) {
  visit(Key{"width", "m", positive, "inner width"}, s.width);
  visit(Key{"height", "m", positive, "height of the gas grid"}, s.height);
  visit(Key{"thickness", "m", positive, "depth of the slab, at least a particle's diameter"}, s.thickness);
  visit(Key{"top", "", {}, "what particles meet at the upper end"}, s.top);
  visit(Key{"sides", "", {}, "what particles and gas meet at the left and right end"}, s.sides);
}

template <class V>
void describe(VibrationSettings& s, V& visit) {
  visit(Key{"amplitude", "m", positive, "the floor's height is this times sin(2 pi frequency t)", true},
        s.amplitude);
  visit(Key{"frequency", "Hz", positive, "of its motion", true}, s.frequency);
}

template <class V>
void describe(FloorSettings& s, V& visit) {
  visit(Key{"inclination_deg", "deg", {0.0, 60.0}, "slope of the distributor, rising to the right"},
        s.inclinationDeg);
  visit(Key{"shape", "", {}, "how particles see an inclined distributor"}, s.shape);
  visit(Key{"vibration", "", {}, "switches on a floor that moves up and down"}, s.vibration);
}

template <class V>
void describe(ObstacleSettings& s, V& visit) {
  visit(Key{"shape", "", {}, "what it is"}, s.shape);
  visit(Key{"x", "m", {}, "centre of a circle or drum"}, s.x);
  visit(Key{"y", "m", {}, "height of its centre"}, s.y);
  visit(Key{"radius", "m", positive, "of a circle or drum"}, s.radius);
  visit(Key{"spin_rpm",
            "1/min",
            {},
            "the circle or drum turns, counter-clockwise; particles feel it by friction"},
        s.spinRpm);
  visit(Key{"x1", "m", {}, "one end of a segment"}, s.x1);
  visit(Key{"y1", "m", {}, "height of that end"}, s.y1);
  visit(Key{"x2", "m", {}, "its other end"}, s.x2);
  visit(Key{"y2", "m", {}, "height of that end"}, s.y2);
  visit(Key{"thickness", "m", positive,
            "of a segment, with round ends, which then stops the gas too; without it the gas passes"},
        s.thickness);
}

template <class V>
void describe(SizeSettings& s, V& visit) {
  visit(Key{"distribution", "", {}, "of the diameters"}, s.distribution);
  visit(Key{"deviation", "", {0.0, 0.5, true}, "standard deviation over the mean; of the logarithm, if that"},
        s.deviation);
  visit(Key{"cut", "", {0.5, 4.0}, "deviations from the mean beyond which there is none"}, s.cut);
}

template <class V>
void describe(SpeciesSettings& s, V& visit) {
  visit(Key{"name", "", {}, "what this kind is called", true}, s.name);
  visit(Key{"count", "", {0.0, 1e8}, "how many of all particles at the start are of it", true}, s.count);
  visit(Key{"diameter", "m", positive, "diameter; that of the first kind where absent"}, s.diameter);
  visit(Key{"density", "kg/m3", positive, "density; that of the first kind where absent"}, s.density);
  visit(Key{"size", "", {}, "sizes that differ"}, s.size);
}

template <class V>
void describe(ParticleSettings& s, V& visit) {
  visit(Key{"count", "", {0.0, 1e8}, "number of particles at the start", true}, s.count);
  visit(Key{"diameter", "m", positive, "diameter of the spheres", true}, s.diameter);
  visit(Key{"density", "kg/m3", positive, "density of the solid", true}, s.density);
  visit(Key{"name", "", {}, "what this first kind is called"}, s.name);
  visit(Key{"size", "", {}, "switches on sizes that differ; diameter is their mean, or median"}, s.size);
  visit(Key{"species", "", {}, "further kinds of particles"}, s.species);
}

template <class V>
void describe(FrictionSettings& s, V& visit) {
  visit(Key{"coefficient", "", notNegative,
            "Coulomb's coefficient: the tangential force stays below it times the normal one"},
        s.coefficient);
  visit(Key{"stiffness_ratio", "", {0.0, 1.0, true}, "tangential over normal spring"}, s.stiffnessRatio);
  visit(Key{"damping_ratio", "", {0.0, 1.0}, "tangential over normal dashpot"}, s.dampingRatio);
}

template <class V>
void describe(PairSettings& s, V& visit) {
  visit(Key{"first", "", {}, "name of a kind of particles", true}, s.first);
  visit(Key{"second", "", {}, "name of a kind, or \"wall\"", true}, s.second);
  visit(Key{"restitution", "", {0.0, 1.0, true}, "of contacts between these"}, s.restitution);
  visit(Key{"friction", "", notNegative, "Coulomb's coefficient between these"}, s.friction);
}

template <class V>
void describe(HertzSettings& s, V& visit) {
  visit(Key{"youngs_modulus", "Pa", {1e3, 1e13}, "of particles and walls", true}, s.youngsModulus);
  visit(Key{"poisson_ratio", "", {0.0, 0.5}, "of particles and walls"}, s.poissonRatio);
}

template <class V>
void describe(RollingSettings& s, V& visit) {
  visit(Key{"model", "", {}, "how rolling is resisted"}, s.model);
  visit(Key{"coefficient", "", {0.0, 2.0, true}, "largest torque over normal force times effective radius"},
        s.coefficient);
  visit(Key{"damping_ratio", "", {0.0, 1.0}, "dashpot of the elastic-plastic spring, of the critical one"},
        s.dampingRatio);
}

template <class V>
void describe(ContactSettings& s, V& visit) {
  visit(Key{"hertz", "", {}, "switches on Hertzian contacts of elastic spheres, instead of stiffness"},
        s.hertz);
  if (s.hertz) s.stiffness.reset();  // which is there only where it is given, too
  visit(Key{"stiffness", "N/m", positive, "normal spring, of pairs and walls; or give hertz", !s.hertz},
        s.stiffness);
  visit(Key{"restitution", "", {0.0, 1.0, true}, "rebound over approach speed; or give damping"},
        s.restitution);
  visit(Key{"damping", "kg/s", notNegative, "normal dashpot of pairs and walls; or give restitution"},
        s.damping);
  visit(Key{"friction", "", {}, "switches on tangential forces and rotation"}, s.friction);
  visit(Key{"rolling", "", {}, "switches on resistance to rolling"}, s.rolling);
  visit(Key{"pairs", "", {}, "what contacts of certain kinds have of their own"}, s.pairs);
}

template <class V>
void describe(TimeSettings& s, V& visit) {
  visit(Key{"duration", "s", positive, "simulated time", true}, s.duration);
  visit(Key{"step", "s", positive, "time step of the particles, or chosen by error"}, s.step);
  visit(Key{"error",
            "sqrt(g d)",
            {0.0, 1.0, true},
            "what a chosen step may change the speed after a contact by; without gravity over its approach"},
        s.error);
  visit(Key{"integrator", "", {}, "how particles are advanced"}, s.integrator);
}

template <class V>
void describe(StartSettings& s, V& visit) {
  visit(Key{"arrangement", "", {}, "how the run begins"}, s.arrangement);
  visit(Key{"above", "m", notNegative, "no particle starts below this height"}, s.above);
}

template <class V>
void describe(TracerSettings& s, V& visit) {
  visit(Key{"rule", "", {}, "which particles are black"}, s.rule);
}

template <class V>
void describe(GasGridSettings& s, V& visit) {
  visit(Key{"columns",
            "m",
            {},
            "[count, size] stretches from left to right; must add up to the bed's width",
            true},
        s.columns);
  visit(Key{"rows",
            "m",
            {},
            "[count, size] stretches from bottom to top; must add up to the bed's height",
            true},
        s.rows);
}

template <class V>
void describe(PulseSettings& s, V& visit) {
  visit(Key{"shape", "", {}, "how what enters goes up and down"}, s.shape);
  visit(Key{"frequency", "Hz", {0.0, 1000.0, true}, "periods in a second"}, s.frequency);
  visit(Key{"amplitude", "", {0.0, 1.0, true}, "of the inlet's velocity; at 1 it comes down to nothing"},
        s.amplitude);
  visit(Key{"duty", "", {0.01, 0.99}, "share of a period that a square pulse is on"}, s.duty);
  visit(Key{"phase", "", {0.0, 1.0}, "share of a period that has gone by when the run begins"}, s.phase);
}

template <class V>
void describe(SchedulePoint& s, V& visit) {
  visit(Key{"time", "s", notNegative, "when", true}, s.time);
  visit(Key{"factor", "", notNegative, "on the inlet's velocity; linear from point to point", true},
        s.factor);
}

template <class V>
void describe(Inlet& s, V& visit) {
  visit(Key{"from", "m", notNegative, "left end on the floor", true}, s.from);
  visit(Key{"to", "m", notNegative, "right end on the floor", true}, s.to);
  visit(Key{"velocity", "m/s", notNegative, "superficial velocity in the inlet; or give velocity_umf"},
        s.velocity);
  visit(
      Key{"velocity_umf", "u_mf", notNegative, "the same in multiples of the minimum fluidization velocity"},
      s.velocityUmf);
  visit(Key{"pulse", "", {}, "switches on a velocity that pulses around this"}, s.pulse);
  visit(Key{"schedule", "", {}, "points in time of a factor on the velocity"}, s.schedule);
}

template <class V>
void describe(GasSettings& s, V& visit) {
  visit(Key{"density", "kg/m3", positive, "density of the gas"}, s.density);
  visit(Key{"viscosity", "Pa s", positive, "dynamic viscosity of the gas"}, s.viscosity);
  visit(Key{"step", "s", positive, "time step of the gas, a multiple of the particles', or chosen by error"},
        s.step);
  visit(Key{"error", "", {0.0, 1.0, true}, "what the drag may change by within a chosen step, relative"},
        s.error);
  visit(Key{"scheme", "", {}, "pressure-velocity coupling"}, s.scheme);
  visit(Key{"time_scheme", "", {}, "time level of convection and diffusion"}, s.timeScheme);
  visit(Key{"drag", "", {}, "drag law"}, s.drag);
  visit(Key{"tolerance", "", {0.0, 0.1, true}, "relative residual at which the scheme's iterations end"},
        s.tolerance);
  visit(Key{"max_iterations", "", {1.0, 1e5}, "limit of the scheme's iterations"}, s.maxIterations);
  visit(Key{"minimum_fluidization_velocity", "m/s", positive, "u_mf; Wen & Yu's correlation where absent"},
        s.minimumFluidizationVelocity);
  visit(Key{"grid", "", {}, "cells of the gas grid", true}, s.grid);
  visit(Key{"inlets", "", {}, "where gas enters the floor", true}, s.inlets);
}

template <class V>
void describe(SamplingSettings& s, V& visit) {
  visit(Key{"columns", "", {1.0, 1e4}, "sampling cells across the bed"}, s.columns);
  visit(Key{"rows", "", {1.0, 1e4}, "sampling cells up the bed"}, s.rows);
  visit(Key{"min_particles", "", {1.0, 1e8}, "cells with fewer particles are not used"}, s.minParticles);
  visit(Key{"interval", "s", positive, "time between samples, which are also the recorded frames"},
        s.interval);
}

template <class V>
void describe(FluxSettings& s, V& visit) {
  visit(Key{"x", "m", notNegative, "position of the upright window", true}, s.x);
  visit(Key{"from", "m", notNegative, "its lower end above the floor there"}, s.from);
  visit(Key{"to", "m", positive, "its upper end above the floor there"}, s.to);
}

template <class V>
void describe(LimitSettings& s, V& visit) {
  visit(Key{"warn_overlap", "", {0.0, 1.0, true}, "overlap over diameter that is reported"}, s.warnOverlap);
  visit(Key{"max_overlap", "", {0.0, 1.0, true}, "overlap over diameter that ends the run"}, s.maxOverlap);
}

template <class V>
void describe(PictureSettings& s, V& visit) {
  visit(Key{"layers", "", {}, "what is shown"}, s.layers);
  visit(Key{"color", "", {}, "what colours the particles"}, s.color);
  visit(Key{"classes", "", {1.0, 1000.0}, "number of classes of the colours height and strips"}, s.classes);
  visit(Key{"background", "", {}, "colour behind the bed"}, s.ground);
  visit(Key{"bubble_voidage", "", {0.0, 1.0, true}, "voidage at which the layer bubbles draws a line"},
        s.bubbleVoidage);
  visit(Key{"trails", "", {0.0, 1e8}, "numbers of the particles that leave a trail, from 0"}, s.trails);
  visit(Key{"trail_time", "s", positive, "time that a trail shows"}, s.trailTime);
}

template <class V>
void describe(Scene& s, V& visit) {
  visit(Key{"title", "", {}, "one line for people"}, s.title);
  visit(Key{"seed", "", {0.0, 9.2e18}, "of the random start"}, s.seed);
  visit(
      Key{"accuracy",
          "",
          {},
          "where time.integrator, step and error, and gas.step, error, scheme and tolerance come from if not "
          "given"},
      s.accuracy);
  visit(Key{"gravity", "m/s2", notNegative, "acceleration, downward"}, s.gravity);
  visit(Key{"bed", "", {}, "the container", true}, s.bed);
  visit(Key{"floor", "", {}, "the distributor"}, s.floor);
  visit(Key{"obstacles", "", {}, "tubes, plates, hopper walls and drums"}, s.obstacles);
  visit(Key{"particles", "", {}, "the solids", true}, s.particles);
  visit(Key{"contacts", "", {}, "what happens where bodies touch", true}, s.contacts);
  visit(Key{"time", "", {}, "duration and step", true}, s.time);
  visit(Key{"start", "", {}, "how the run begins"}, s.start);
  visit(Key{"tracer", "", {}, "what mixes with what"}, s.tracer);
  visit(Key{"gas", "", {}, "switches on the gas"}, s.gas);
  s.effects.forEach([&](const Key& table, auto& settings) { visit(table, settings); });
  visit(Key{"sampling", "", {}, "cells and interval of the mixing indices"}, s.sampling);
  visit(Key{"flux", "", {}, "switches on the solids flux through an upright window"}, s.flux);
  visit(Key{"limits", "", {}, "when a run is stopped"}, s.limits);
  visit(Key{"pictures", "", {}, "what pictures show where the command line does not say"}, s.pictures);
}

}  // namespace bedmix
