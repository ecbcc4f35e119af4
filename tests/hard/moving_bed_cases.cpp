// SPDX-License-Identifier: MIT
#include "engine/core/bed_statistics.h"
#include "tests/gas/fixed_bed.h"
#include "tests/gas/gas_scenes.h"
#include "tests/hard/hard_beds.h"
#include "tests/hard/hard_case.h"

#include <utility>

namespace bedmix::hard {

namespace {

/// A bed that is watched while it moves.
class Watched {
 public:
  Watched(const Scene& scene, Simulation simulation)
      : scene_(scene), grid_(makeGasGrid(scene)), simulation_(std::move(simulation)) {}
  explicit Watched(const Scene& scene) : Watched(scene, test::simulate(scene)) {}

  void advance(double seconds) {
    const double glance = std::max<double>(1e-3, scene_.gas->step);
    for (double t = 0.5 * glance; t < seconds; t += glance) {
      go(simulation_, std::llround(glance / scene_.time.step));
      const FramePtr now = frame();
      for (const float eps : now->gas.voidage) solids_ = std::max(solids_, 1.0 - double{eps});
    }
  }
  void blow(double velocity) { simulation_.setInlets({{0.0, scene_.bed.width, velocity, std::nullopt}}); }
  FramePtr frame() const { return simulation_.frame(); }
  const GasGrid& grid() const { return grid_; }

  double fastest() const {
    const FramePtr now = frame();
    double speed = 0.0;
    for (const Vec2f v : now->velocity) speed = std::max(speed, std::hypot(double{v.x}, double{v.y}));
    return speed;
  }
  double above(double height) const {
    const FramePtr f = frame();
    return static_cast<double>(
        std::count_if(f->position.begin(), f->position.end(), [&](Vec2f p) { return double{p.y} > height; }));
  }
  double meanUpward() const {
    const FramePtr now = frame();
    double sum = 0.0;
    for (const Vec2f v : now->velocity) sum += double{v.y};
    return sum / static_cast<double>(scene_.particles.count);
  }
  /// Superficial velocity of the gas through the middle of a row without particles, m/s.
  double gasThrough(int row) const {
    const FramePtr f = frame();
    double flow = 0.0;
    for (int c = 0; c < grid_.columns; ++c)
      flow += double{f->gas.velocity[grid_.cell(c, row)].y} * grid_.dx(c) / scene_.bed.width;
    return flow;
  }

  /// What holds of any bed.
  std::vector<Check> checks(const std::string& what = "") const {
    const StepReport& r = simulation_.report();
    const double limit = scene_.limits.maxOverlap;
    return {{what + "mass residual of any cell and step", 1e-10, "pressure solved to 1e-12 of the inflow",
             r.largestMassResidual},
            {what + "solids fraction of any cell", pi / (3.0 * std::sqrt(3.0)) / std::pow(1.0 - limit, 2.0),
             "closest packing at the largest overlap", solids_}};
  }

 private:
  Scene scene_;
  GasGrid grid_;
  Simulation simulation_;
  double solids_ = 0.0;
};

void append(std::vector<Check>& to, std::vector<Check> more) {
  to.insert(to.end(), more.begin(), more.end());
}

std::vector<Check> noneOneTwo() {
  std::vector<Check> checks;
  for (const std::int64_t count : {0, 1, 2}) {
    Watched bed(test::lowScene(count, 2.6));
    bed.advance(0.05);
    const std::string what = fmt::format("N = {}: ", count);
    append(checks, bed.checks(what));
    checks.push_back({what + "gas through the upper cells over what enters, less 1", 1e-6,
                      "continuity; frames are single precision", std::abs(bed.gasThrough(9) / 2.6 - 1.0)});
  }
  return checks;
}

/// Springs that hold what falls from a metre.
Scene hardScene(std::int64_t particles, double superficial) {
  Scene scene = test::lowScene(particles, superficial);
  scene.contacts.stiffness = 50000.0;
  return scene;
}

std::vector<Check> gasOnAndOff() {
  const Scene scene = hardScene(100, 0.0);
  Watched bed(scene);
  bed.advance(0.05);
  bed.blow(10.0 * minimumFluidizationVelocity(scene));
  bed.advance(0.15);
  const double risen = bed.above(0.06);
  bed.blow(0.0);
  bed.advance(3.0);
  std::vector<Check> checks = bed.checks();
  const double still = scene.gas->density * scene.gravity * (0.12 - 0.006);
  // Spheres that still move at 1 mm/s drag the gas along, as Ergun has it at voidage 0.4, through 60 mm at
  // most.
  const double drag = test::ergunGradient(0.4, 1e-3, scene) * 0.06;
  checks.push_back({"spheres of 100 that were not lifted above 60 mm", 0.0,
                    "10 u_mf is above their terminal velocity", 100.0 - risen});
  checks.push_back({"fastest sphere 3 s after the gas was shut off, m/s", 1e-3,
                    "they rest, as 'settled' means it", bed.fastest()});
  checks.push_back({"pressure drop over the weight of still gas, less 1", drag / still, "what 1 mm/s drags",
                    std::abs(pressureDrop(*bed.frame(), bed.grid()) / still - 1.0)});
  return checks;
}

/// While no sphere touches the floor or has reached the outlet, the gas alone carries and accelerates them:
/// its impulse, by the pressure at the floor, less theirs, of the larger one.
double impulseError(const Scene& scene) {
  Simulation simulation = test::simulate(scene);
  const GasGrid grid = makeGasGrid(scene);
  const double d = scene.particles.diameter, area = scene.bed.width * scene.bed.thickness;
  const double mass = particleMass(scene), gasWeight = scene.gas->density * scene.gravity;
  double given = 0.0, taken = 0.0, momentum = 0.0;
  bool flies = false;
  for (double t = 0.0; t < 0.5; t += scene.gas->step) {
    const double pressure = flies ? pressureDrop(*simulation.frame(), grid) : 0.0;
    go(simulation, stepsPerGasStep(scene));
    const FramePtr now = simulation.frame();
    const double before = momentum;
    momentum = 0.0;
    for (const Vec2f v : now->velocity) momentum += mass * double{v.y};
    if (flies) {
      given += area * (pressure + gasWeight * (0.5 * grid.dy(0) - scene.bed.height)) * scene.gas->step;
      taken += momentum - before + mass * scene.gravity * static_cast<double>(now->size()) * scene.gas->step;
    }
    const auto [low, high] = std::minmax_element(now->position.begin(), now->position.end(),
                                                 [](Vec2f a, Vec2f b) { return a.y < b.y; });
    flies = double{low->y} > 1.5 * d && double{high->y} < scene.bed.height - 6.0 * d;
  }
  return std::abs(given / taken - 1.0);
}

std::vector<Check> slug() {
  Scene scene = hardScene(100, 4.0);
  scene.contacts.friction.reset();
  scene.bed.width = 0.012;
  scene.bed.height = 0.36;
  scene.gas->grid = {{{2, 0.006}}, {{60, 0.006}}};
  scene.gas->inlets = {{0.0, 0.012, 4.0, std::nullopt}};
  Watched bed(scene);
  bed.advance(0.5);
  std::vector<Check> checks = bed.checks();
  // Walls hold the gas at most as in wallShare() of the fixed beds, all the way up; and gas is accelerated
  // too.
  const double friction = 4.0 * scene.gas->viscosity * 4.0 / (0.4 * 0.006 * 0.012) * scene.bed.height /
                          (100.0 * particleMass(scene) * scene.gravity / (0.012 * scene.bed.thickness));
  for (const double step : {1e-4, 1e-3}) {
    scene.gas->step = step;
    checks.push_back(
        {fmt::format("gas step {:g} s: impulse of the gas over that of the flying slug, less 1", step),
         friction + 2.0 * scene.gas->density / scene.particles.density,
         "Newton; friction of the gas at the walls, its own inertia and buoyancy", impulseError(scene)});
  }
  return checks;
}

std::vector<Check> blownOut() {
  Scene scene = hardScene(100, 25.0);
  scene.contacts.friction.reset();
  Watched bed(scene);
  bed.advance(0.2);
  const double left = 100.0 - bed.above(0.125), before = bed.meanUpward();
  bed.advance(0.1);
  std::vector<Check> checks = bed.checks();
  checks.push_back(
      {"spheres of 100 still in the bed after 0.2 s", 0.0, "25 m/s is twice their terminal velocity", left});
  checks.push_back({"their mean acceleration over -g, less 1", 1e-4, "free fall; speeds of single precision",
                    std::abs((before - bed.meanUpward()) / (0.1 * scene.gravity) - 1.0)});
  checks.push_back({"gas through the empty bed over what enters, less 1", 1e-6,
                    "continuity; frames are single precision", std::abs(bed.gasThrough(5) / 25.0 - 1.0)});
  return checks;
}

std::vector<Check> singleInCell() {
  Scene scene = test::lowScene(1, 1.0);
  scene.gas->grid = {{{8, 0.006}}, {{20, 0.006}}};
  Watched bed(scene);
  bed.advance(0.3);
  std::vector<Check> checks = bed.checks();
  checks.back().bound = particleVolume(scene) / (0.006 * 0.006 * 0.004) * (1.0 + 1e-6);
  checks.back().from = "one sphere in one cell";
  return checks;
}

/// A bed at 2 u_mf on some grid.
std::vector<Check> fluidized(const std::string& what, GridSpan columns, GridSpan rows, double gasStep) {
  Scene scene = test::paperScene(0.0);
  scene.bed.width = static_cast<double>(columns.count) * columns.size;
  scene.bed.height = static_cast<double>(rows.count) * rows.size;
  scene.particles.count = 150;
  scene.contacts.stiffness = 20000.0;
  scene.gas->grid = {{columns}, {rows}};
  scene.gas->step = gasStep;
  scene.gas->inlets = {{0.0, scene.bed.width, std::nullopt, 2.0}};
  Watched bed(scene);
  bed.advance(0.5);
  return bed.checks(what + ": ");
}

std::vector<Check> grids() {
  std::vector<Check> checks = fluidized("cells of 1.5 d", {8, 0.006}, {50, 0.006}, 1e-4);
  append(checks, fluidized("cells of 10 d", {2, 0.04}, {8, 0.04}, 1e-4));
  append(checks, fluidized("cells 1:8", {2, 0.032}, {75, 0.004}, 1e-4));
  append(checks, fluidized("cells 8:1", {12, 0.004}, {10, 0.032}, 1e-4));
  return checks;
}
std::vector<Check> largeGasStep() { return fluidized("10 ms", {4, 0.012}, {25, 0.012}, 1e-2); }

std::vector<Check> neutral() {
  Scene scene = test::lowScene(150, 0.0);
  scene.start.arrangement = Arrangement::drop;
  scene.gas->density = scene.particles.density;
  scene.gas->viscosity = 1e-3;
  Watched bed(scene);
  double fastest = 0.0;
  for (int k = 0; k < 100; ++k) {
    bed.advance(0.01);
    fastest = std::max(fastest, bed.fastest());
  }
  std::vector<Check> checks = bed.checks();
  checks.push_back({"fastest sphere within 1 s of rest, m/s", scene.gravity * scene.gas->step,
                    "what it falls before gas meets it: g times the gas step", fastest});
  return checks;
}

std::vector<Check> neutralFlow() {
  Scene scene = test::lowScene(150, 0.0);
  scene.gas->density = scene.particles.density;
  scene.gas->viscosity = 1e-3;
  Watched bed(scene);
  bed.blow(0.2);
  bed.advance(0.5);
  bed.blow(0.0);
  bed.advance(0.5);
  return bed.checks();
}

std::vector<Check> denseBesideEmpty() {
  Scene scene = test::lowScene(0, 1.3);
  const double spacing = 0.004 * std::sqrt(pi / (3.0 * std::sqrt(3.0)) / 0.64),
               rise = spacing * std::sqrt(0.75);
  std::vector<Vec2> centres;
  for (int row = 0; 0.0019 + row * rise < 0.1; ++row)
    for (double x = 0.0019 + spacing * 0.5 * (row % 2); x < 0.024; x += spacing)
      centres.push_back({x, 0.0019 + row * rise});
  scene.particles.count = static_cast<std::int64_t>(centres.size());
  Watched bed(scene, Simulation::make(scene, makeParticles(scene, centres)));
  bed.advance(0.5);
  return bed.checks();
}

std::vector<Check> crystal() {
  Scene scene = test::lowScene(0, 2.6);
  const std::vector<Vec2> centres = hexagonal(0.004, 12, 15);
  scene.particles.count = static_cast<std::int64_t>(centres.size());
  scene.contacts.stiffness = 20000.0;
  Watched bed(scene, Simulation::make(scene, makeParticles(scene, centres)));
  bed.advance(0.5);
  return bed.checks();
}

/// Sand of 0.2 mm in water.
Scene sandScene() {
  Scene scene = test::lowScene(1000, 0.0);
  scene.bed = {0.0048, 0.02, 0.0002, BedTop::open};
  scene.particles = {1000, 0.0002, 2500.0};
  scene.contacts.stiffness = 20.0;
  scene.gas->density = 1000.0;
  scene.gas->viscosity = 1e-3;
  scene.gas->grid = {{{8, 0.0006}}, {{25, 0.0008}}};
  scene.gas->inlets = {{0.0, 0.0048, std::nullopt, 3.0}};
  return scene;
}

/// Gas steps from the start until the run is stopped.
double gasStepsToStop(const Scene& scene) {
  Simulation simulation = test::simulate(scene);
  return simulation.advance(100 * stepsPerGasStep(scene)) ? static_cast<double>(simulation.gasSteps())
                                                          : infinity;
}
/// As many as take the round-off of a velocity, doubled in each, to where springs give way.
double doublings(const Scene& scene, double velocity) {
  const double limit = scene.limits.maxOverlap * scene.particles.diameter *
                       std::sqrt(2.0 * normalStiffness(scene) / particleMass(scene));
  return std::ceil(std::log2(limit / (velocity * std::numeric_limits<double>::epsilon()))) + 1.0;
}
constexpr const char* doubled = "round-off of the velocity, doubled in each, breaks the limit";

std::vector<Check> stiffDrag() {
  Scene scene = sandScene();
  scene.gas->step = 1.4e-4;
  Watched bed(scene);
  bed.advance(0.5);
  std::vector<Check> checks = bed.checks("gas step at the limit: ");
  checks.push_back(
      {"gas step at the limit: refused by check, 1 = yes", 0.0, "", refused(scene, "gas.step") ? 1.0 : 0.0});
  scene.gas->step = 1e-3;
  checks.push_back({"7 times the limit: let pass by check, 1 = yes", 0.0,
                    "gas and particles overshoot each other", refused(scene, "gas.step") ? 0.0 : 1.0});
  checks.push_back({"7 times the limit, forced: gas steps to the stop",
                    doublings(scene, inletVelocity(scene, scene.gas->inlets[0])), doubled,
                    gasStepsToStop(scene)});
  return checks;
}

std::vector<Check> lightSpheres() {
  Scene scene = test::lowScene(150, 0.2);
  scene.gas->viscosity = 1e-3;
  scene.gas->density = 4.0 / 3.0 * scene.particles.density;
  Watched bed(scene);
  bed.advance(0.5);
  std::vector<Check> checks = bed.checks("gas 4/3 as dense: ");
  checks.push_back({"gas 4/3 as dense: refused by check, 1 = yes", 0.0, "",
                    refused(scene, "particles.density") ? 1.0 : 0.0});
  scene.gas->density = 3.0 * scene.particles.density;
  checks.push_back({"3 times as dense: let pass by check, 1 = yes", 0.0,
                    "gas and particles overshoot each other",
                    refused(scene, "particles.density") ? 0.0 : 1.0});
  checks.push_back({"3 times as dense, forced: gas steps to the stop", doublings(scene, 0.2), doubled,
                    gasStepsToStop(scene)});
  return checks;
}

}  // namespace

std::vector<HardCase> movingBedCases() {
  return {{"none, one and two particles", noneOneTwo},
          {"gas 0, 10 u_mf, 0", gasOnAndOff},
          {"choking slug in a tube 3 d wide", slug},
          {"all spheres blown out", blownOut},
          {"a single sphere in cells of 1.5 d", singleInCell},
          {"coarse, fine, flat and tall cells at 2 u_mf", grids},
          {"gas step 100 times the default at 2 u_mf", largeGasStep},
          {"gas as dense as the spheres, at rest", neutral},
          {"gas as dense as the spheres, 0.2 m/s on and off", neutralFlow},
          {"voidage 0.36 beside empty cells, let go", denseBesideEmpty},
          {"hexagonal crystal at 2 u_mf", crystal},
          {"0.2 mm sand in water: stiff drag", stiffDrag},
          {"spheres lighter than the gas", lightSpheres}};
}

}  // namespace bedmix::hard
