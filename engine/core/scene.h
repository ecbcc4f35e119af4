// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/inlet_pulse.h"
#include "engine/core/models.h"
#include "engine/core/picture_settings.h"
#include "engine/core/step_length.h"
#include "engine/effects/settings.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// A scene says everything a run depends on. Each settings struct below is one TOML table; its defaults stand
// here and nowhere else, its keys, units, ranges and meanings in scene_description.h. A table behind
// std::optional switches an effect on by being there. SI units; a unit that is not SI is part of the name.

namespace bedmix {

struct BedSettings {
  double width = 0.096;      // m
  double height = 0.42;      // m
  double thickness = 0.004;  // m
  BedTop top = BedTop::open;
  BedSides sides = BedSides::walls;
};

/// The floor moves by amplitude sin(2 pi frequency t), upward.
struct VibrationSettings {
  double amplitude = 0.0;  // m
  double frequency = 0.0;  // Hz
};

struct FloorSettings {
  double inclinationDeg = 0.0;  // rises to the right
  FloorShape shape = FloorShape::straight;
  std::optional<VibrationSettings> vibration = {};
};

/// A circle or drum about (x, y), or a segment from (x1, y1) to (x2, y2).
struct ObstacleSettings {
  ObstacleShape shape = ObstacleShape::circle;
  std::optional<double> x = {}, y = {}, radius = {};         // m, of a circle or drum
  std::optional<double> spinRpm = {};                        // 1/min, of its surface, counter-clockwise
  std::optional<double> x1 = {}, y1 = {}, x2 = {}, y2 = {};  // m, of a segment
  std::optional<double> thickness = {};                      // m; without any it is no obstacle to the gas
};

/// Spheres of many sizes instead of one.
struct SizeSettings {
  SizeDistribution distribution = SizeDistribution::normal;
  double deviation = 0.1;  // standard, of the mean; of a log-normal one, of the logarithm
  double cut = 2.5;        // none is further from the mean, in deviations
};

/// A further kind of particles.
struct SpeciesSettings {
  std::string name;
  std::int64_t count = 0;          // of all
  std::optional<double> diameter;  // m; of the first kind where absent, as are the others
  std::optional<double> density;   // kg/m3
  std::optional<SizeSettings> size;
};

/// The first kind, and how many there are of all kinds together.
struct ParticleSettings {
  std::int64_t count = 1000;
  double diameter = 0.004;  // m; the mean one where sizes differ, the median of log-normal ones
  double density = 1500.0;  // kg/m3
  std::string name = "first";
  std::optional<SizeSettings> size = {};
  std::vector<SpeciesSettings> species = {};
};

struct FrictionSettings {
  double coefficient = 0.3;
  double stiffnessRatio = 2.0 / 7.0;  // tangential over normal spring
  double dampingRatio = 2.0 / 7.0;    // tangential over normal dashpot
};

/// What contacts between two kinds, or of one with the walls, have of their own.
struct PairSettings {
  std::string first, second;  // names of kinds; the second may be "wall"
  std::optional<double> restitution;
  std::optional<double> friction;  // coefficient
};

/// Elastic spheres instead of linear springs.
struct HertzSettings {
  double youngsModulus = 1e7;  // Pa
  double poissonRatio = 0.25;
};

/// Torque against rolling.
struct RollingSettings {
  RollingModel model = RollingModel::elasticPlastic;
  double coefficient = 0.1;
  double dampingRatio = 0.3;  // of the elastic-plastic one's spring, of critical
};

struct ContactSettings {
  std::optional<double> stiffness = 2000.0;  // N/m; exactly one of
  std::optional<HertzSettings> hertz;        // these two
  std::optional<double> restitution;         // exactly one of
  std::optional<double> damping;             // these two; kg/s
  std::optional<FrictionSettings> friction;
  std::optional<RollingSettings> rolling;
  std::vector<PairSettings> pairs;
};

struct TimeSettings {
  double duration = 10.0;  // s
  StepLength step = 1e-5;  // s, of the particles
  Integrator integrator = Integrator::velocityVerlet;
  double error = 0.003;  // of an automatic step: of the speed after a contact, over sqrt(g d)
};

struct StartSettings {
  Arrangement arrangement = Arrangement::settled;
  std::optional<double> above;  // m, below which no particle starts
};

struct TracerSettings {
  TracerRule rule = TracerRule::leftHalf;
};

/// `count` cells of `size` metres each, a stretch of a gas grid.
struct GridSpan {
  std::int64_t count = 1;
  double size = 0.0;  // m
};

/// Gas enters the floor between x = from and x = to with this velocity (volume flux per area of the inlet).
struct Inlet {
  double from = 0.0;                         // m
  double to = 0.0;                           // m
  std::optional<double> velocity;            // m/s, exactly one of
  std::optional<double> velocityUmf;         // these two; multiples of the minimum fluidization velocity
  std::optional<PulseSettings> pulse = {};   // around that velocity
  std::vector<SchedulePoint> schedule = {};  // of factors on it
};

struct GasGridSettings {
  std::vector<GridSpan> columns;  // left to right
  std::vector<GridSpan> rows;     // bottom to top
};

struct GasSettings {
  double density = 1.205;      // kg/m3
  double viscosity = 1.82e-5;  // Pa s
  StepLength step = 1e-4;      // s, a multiple of the particles' step
  double error = 0.015;        // of an automatic step: change of the drag within it, relative
  GasScheme scheme = GasScheme::projection;
  TimeScheme timeScheme = TimeScheme::crankNicolson;
  DragLaw drag = DragLaw::ergunWenYu;
  double tolerance = 1e-6;           // relative residual at which the scheme's outer loop ends
  std::int64_t maxIterations = 200;  // of the outer loop
  std::optional<double> minimumFluidizationVelocity;  // m/s; Wen-Yu's correlation where absent
  GasGridSettings grid;
  std::vector<Inlet> inlets;
};

struct SamplingSettings {
  std::int64_t columns = 4;
  std::int64_t rows = 15;
  std::int64_t minParticles = 21;  // a cell with fewer is not used
  double interval = 0.01;          // s, between frames and samples
};

/// The upright window the solids flux is measured through; heights count from the floor at x.
struct FluxSettings {
  double x = 0.0;     // m
  double from = 0.0;  // m
  double to = 0.1;    // m
};

struct LimitSettings {
  double warnOverlap = 0.01;  // of a diameter
  double maxOverlap = 0.1;    // of a diameter: the run stops
};

/// How often steps have been halved; see refinement.h. A gas step is a whole number of the particles' steps,
/// so its are never more.
struct Refinement {
  std::int64_t particles = 0;
  std::int64_t gas = 0;

  bool operator==(const Refinement&) const = default;
};

struct Scene {
  std::string name;  // of the file or the bundled scene, not a key
  std::string title;
  std::uint64_t seed = 1;
  std::optional<Accuracy> accuracy;  // the preset that numerics come from where the scene does not give them
  double gravity = 9.81;             // m/s2, downward
  BedSettings bed;
  FloorSettings floor;
  std::vector<ObstacleSettings> obstacles;
  ParticleSettings particles;
  ContactSettings contacts;
  TimeSettings time;
  StartSettings start;
  TracerSettings tracer;
  std::optional<GasSettings> gas;
  EffectSettings effects;  // whose tables stand at the top of the file
  SamplingSettings sampling;
  std::optional<FluxSettings> flux;
  LimitSettings limits;
  std::optional<PictureSettings> pictures;  // what they show where nobody says otherwise
  Refinement refinement;                    // of the steps since the scene was read, not a key
  std::optional<double> tickKept;           // s, of a run that is steered: see tick(); not a key
};

// What follows from the settings.

double particleMass(const Scene& scene);    // kg, of the first kind's
double particleVolume(const Scene& scene);  // m3
/// Of a particle, kg: those that make the shortest steps. All masses are this one where all are alike.
double lightestMass(const Scene& scene);
/// Weight of all particles over the area the bed stands on, Pa: what the gas has to carry.
double bedWeight(const Scene& scene);
/// The normal spring, N/m; of a Hertzian contact, whose spring stiffens with the overlap, that which gives
/// the same force at limits.warn_overlap, of the smallest particle at a wall: ordinary contacts are softer.
double normalStiffness(const Scene& scene);
/// Of a contact that overlaps by so much (m), N; of particles of that effective radius, m, r1 r2/(r1 + r2) or
/// of one at a wall its own.
double elasticForce(const Scene& scene, double overlap, double effectiveRadius);
/// E* of two bodies of the same material, Pa: E/(2 (1 - nu^2)).
double effectiveModulus(const HertzSettings& hertz);
/// Normal dashpot, kg/s, between two particles and between a particle and a wall, of the lightest. From
/// `restitution`, each gets the value that gives it; from `damping`, both get that.
double pairDamping(const Scene& scene);
double wallDamping(const Scene& scene);
/// The dashpot, kg/s, at which two bodies of reduced mass m (kg) on a spring k (N/m) rebound with restitution
/// e: zeta = -ln e / sqrt(pi^2 + ln^2 e), eta = 2 zeta sqrt(m k).
double dampingFor(double restitution, double stiffness, double reducedMass);
/// 2 pi sqrt(m/k), s: Tian et al. (2007), Eq. (10).
double contactTimeScale(const Scene& scene);
/// Minimum fluidization velocity, m/s, after Wen & Yu (1966): Re = sqrt(33.7^2 + 0.0408 Ar) - 33.7; or the
/// scene's own.
double minimumFluidizationVelocity(const Scene& scene);
/// Superficial velocity of an inlet, m/s; where it pulses, its mean over a period.
double inletVelocity(const Scene& scene, const Inlet& inlet);
/// The largest that any inlet ever has, m/s; the scene must have gas.
double fastestInlet(const Scene& scene);
/// Height of the straight distributor at x, m.
double floorHeight(const Scene& scene, double x);

/// The longest step, s, at which contacts are resolved: T/14 (measured, see assets/docs/hard-cases.md).
double longestStep(const Scene& scene);

/// Voidage of a packed bed, where gas and particles hold each other closest.
inline constexpr double packedVoidage = 0.4;
/// How much stronger than Ergun's viscous part a law's drag is there without slip; 1 where it is not.
double packedDragOverErgun(DragLaw law);
/// What a particle of a packed bed has of inertia over its volume, kg/m3: its own density, with virtual mass
/// that of the gas that it takes along besides.
double packedInertia(const Scene& scene, double density);
/// Time, s, within which the particles of a packed bed follow the gas without slip.
double packedRelaxation(const Scene& scene);
/// The longest gas step, s, that holds. Together gas and particles keep their volume: particles of a packed
/// bed that are faster by v slow the gas by (1-e)/e v, and feel by drag and pressure (1-e^2)/e^2 v of it one
/// gas step later, in as far as they relax within the step. More than twice v would grow from step to step.
double longestGasStep(const Scene& scene);

/// The unit that steps, frames and checkpoints are counted in, s: the particles' step. An automatic one is
/// counted in gas steps, or, where there are none of a given length, in equal parts of the sampling interval,
/// each at most T/100 long and so many that most numbers of gas steps fit. Of a run that is steered it stays
/// what it was, however T changes.
double tick(const Scene& scene);
/// Whole numbers of ticks that make one frame, one gas step of a given length, the whole run; times that do
/// not divide are refused by the scene reader.
std::int64_t stepsPerFrame(const Scene& scene);
std::int64_t stepsPerGasStep(const Scene& scene);
std::int64_t totalSteps(const Scene& scene);
/// Time of a tick, s. Divides by the step rate where that is whole, so that step 7000 of 1e-5 s is 0.07 and
/// not 0.07000000000000001.
double timeOfStep(const Scene& scene, std::int64_t step);

}  // namespace bedmix
