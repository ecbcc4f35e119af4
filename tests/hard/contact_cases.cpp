// SPDX-License-Identifier: MIT
#include "tests/hard/hard_beds.h"
#include "tests/hard/hard_case.h"

namespace bedmix::hard {

namespace {

// What velocity Verlet may do to the energy where a spring of frequency w begins or ends inside a step: the
// kick there lacks, or has too much of, w^2 x (v dt - x), x from 0 to v dt. That is (w dt)^2/4 of the kinetic
// energy at most, (w dt)^2/8 of the speed, of either sign at either end.
constexpr const char* kickAtTheEdge = "(w dt)^2/8: a spring that ends inside a step";

std::vector<Check> halfOverlapElastic() {
  Scene scene = smoothSpheres();
  scene.contacts.restitution = 1.0;
  scene.limits.maxOverlap = 0.6;
  const double d = scene.particles.diameter, overlap = d / 2.0;
  const auto solver = solverAt(scene, {{0.0, 0.0}, {0.6 * overlap, 0.8 * overlap}});
  go(*solver, 1000);
  const Particles& p = solver->particles();
  const double exact = overlap * std::sqrt(2.0 * normalStiffness(scene) / p.mass);
  const double parting = norm(p.velocity[1] - p.velocity[0]);
  return {{"parting speed is that of the spring's energy", std::pow(pairAngle(scene), 2.0) / 8.0,
           kickAtTheEdge, std::abs(parting / exact - 1.0)},
          {"momentum over m v", 1e-14, "round-off", norm(p.velocity[0] + p.velocity[1]) / parting}};
}

// No walls: what flies apart here is too fast for them.
std::vector<Check> halfOverlapCluster() {
  Scene scene = smoothSpheres();
  scene.contacts.friction.emplace();
  scene.limits.maxOverlap = 0.6;
  const double spacing = scene.particles.diameter / 2.0;
  std::vector<Vec2> positions;
  for (int i = 0; i < 100; ++i) positions.push_back({spacing * (i % 10), spacing * (i / 10)});
  const auto solver = solverAt(scene, positions);
  go(*solver, 0);
  const double start = energy(*solver);
  double highest = 0.0;
  for (int k = 0; k < 2000; ++k) {
    go(*solver, 1);
    highest = std::max(highest, energy(*solver) / start);
  }
  Vec2 sum;
  double sizes = 0.0;
  for (const Vec2 v : solver->particles().velocity) sum += v, sizes += norm(v);

  scene.limits = {};
  const auto trouble = solverAt(scene, positions)->advance(1000);
  return {{"largest energy over that at the start", 1.0, "dashpots and friction only take", highest},
          {"momentum over the sum of all m v", 1e-13, "round-off", norm(sum) / sizes},
          {"steps to the stop under the default limit of 0.1 d", 1.0, "looked at once a step",
           trouble ? static_cast<double>(trouble->steps) : infinity}};
}

/// A sphere that comes down on ten, at rest on the floor, with 20 m/s.
struct Impact {
  Scene scene = smoothSpheres();
  std::unique_ptr<ParticleSolver> solver;
  static constexpr double speed = 20.0, gap = 1e-6;

  Impact(double stiffness, double step) {
    scene.gravity = 9.81;
    scene.contacts.stiffness = stiffness;
    scene.time.step = step;
    std::vector<Vec2> positions;
    for (int i = 0; i < 11; ++i)
      positions.push_back({0.0, (0.5 + i) * scene.particles.diameter + (i == 10 ? gap : 0.0)});
    solver = solverAt(scene, positions, wideFloor());
    solver->particles().velocity[10].y = -speed;
  }
};

std::vector<Check> impactOnSoftStack() {
  Impact impact(2000.0, 1e-5);
  const auto trouble = impact.solver->advance(100000);
  const double limit = impact.scene.limits.maxOverlap * impact.scene.particles.diameter;
  // The top pair sinks in at w^-1 sin(w t) times the speed and slower, and is looked at once a step.
  const double w = pairAngle(impact.scene) / impact.scene.time.step;
  const double due = (Impact::gap / Impact::speed + std::asin(limit * w / Impact::speed) / w) / 1e-5;
  const bool named = trouble && trouble->kind == DemTrouble::Kind::overlap && trouble->particle >= 9;
  return {{"steps from the limit of 0.1 d to the stop that names the pair", 2.0, "looked at once a step",
           named ? std::abs(static_cast<double>(trouble->steps) - due) : infinity}};
}

std::vector<Check> impactOnStiffStack() {
  Impact impact(2e5, 1e-6);
  go(*impact.solver, 0);
  const double m = particleMass(impact.scene), start = energy(*impact.solver);
  double highest = 0.0;
  for (int k = 0; k < 20000; ++k) {
    go(*impact.solver, 1);
    highest = std::max(highest, energy(*impact.solver) / start);
  }
  return {{"deepest contact over the one that takes all energy", 1.0, "v sqrt(m/k)",
           impact.solver->largestOverlap() * impact.scene.particles.diameter /
               (Impact::speed * std::sqrt(m / normalStiffness(impact.scene)))},
          {"largest energy over that at the start", 1.0 + std::pow(pairAngle(impact.scene), 2.0) / 4.0,
           "(w dt)^2/4: a spring that begins inside a step", highest}};
}

std::vector<Check> frictionZero() {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  scene.contacts.friction = FrictionSettings{.coefficient = 0.0};
  const double sag = particleMass(scene) * scene.gravity / normalStiffness(scene);
  const auto solver = solverAt(scene, {{0.0, scene.particles.diameter / 2.0 - sag}}, wideFloor());
  solver->particles().velocity[0].x = 0.5;
  go(*solver, 100000);
  const Particles& p = solver->particles();
  return {{"speed lost and spin gained by a sliding sphere, m/s", 0.0, "no force along the floor",
           std::abs(p.velocity[0].x - 0.5) + std::abs(p.spin[0]) * p.radius}};
}

std::vector<Check> frictionOne() {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  scene.contacts.friction = FrictionSettings{.coefficient = 1.0};
  const double sag = particleMass(scene) * scene.gravity / normalStiffness(scene);
  const auto slider = solverAt(scene, {{0.0, scene.particles.diameter / 2.0 - sag}}, wideFloor());
  slider->particles().velocity[0].x = 0.5;
  go(*slider, 100000);

  std::vector<Vec2> positions;
  for (int i = 0; i < 144; ++i) positions.push_back({0.005 * (0.5 + i % 12), 0.005 * (0.5 + i / 12)});
  const auto crowd = solverAt(scene, positions, closedBox(0.06, 0.07));
  for (int i = 0; i < 144; ++i) crowd->particles().velocity[i] = {std::sin(2.3 * i + 0.4), std::cos(1.7 * i)};
  go(*crowd, 0);
  double before = energy(*crowd), rise = 0.0;
  const double start = before;
  for (int k = 0; k < 100; ++k) {
    go(*crowd, 1000);
    const double now = energy(*crowd);
    rise = std::max(rise, (now - before) / start);
    before = now;
  }
  return {{"sphere on the floor ends rolling at 5/7 of its speed", 1e-9,
           "angular momentum about the floor, exact; a swing of 30 decay times is left",
           std::abs(slider->particles().velocity[0].x / 0.5 - 5.0 / 7.0)},
          {"rise of the energy of 144 spheres within any 0.01 s, of that at the start", 0.0,
           "dashpots and friction only take", rise}};
}

/// Largest change of the energy of an elastic pair that bounces between two walls.
double driftOfElasticPair(Scene scene) {
  scene.contacts.restitution = 1.0;
  constexpr std::int64_t pieces = 1000, steps = 10000;
  const auto solver = solverAt(scene, {{0.0061, 0.01}, {0.0152, 0.01}}, closedBox(0.02, 0.02));
  solver->particles().velocity = {{0.3, 0.0}, {-0.11, 0.0}};
  go(*solver, 0);
  const double start = energy(*solver);
  double drift = 0.0;
  for (std::int64_t k = 0; k < pieces; ++k) {
    go(*solver, steps);
    drift = std::max(drift, std::abs(energy(*solver) / start - 1.0));
  }
  return drift;
}

std::vector<Check> longElasticPair() {
  Scene verlet = smoothSpheres(), onset = verlet;
  onset.time.integrator = Integrator::verletOnset;
  // A contact's beginning and end each change the energy by (w dt)^2 u (1 - u), u the phase of the step,
  // which has a standard deviation of 1/sqrt(180); four standard deviations of the sum. Between two walls 12
  // mm wide enough for the centres, each crossing of some 0.3 m/s ends in two contacts. With verlet-onset the
  // speed after each lacks (w dt)^4/16 at most, and always lacks it.
  const double contacts = 2.0 * 100.0 * 0.3 / 0.012;
  const double angle = pairAngle(verlet);
  return {{"energy of a bouncing pair, change over 1e7 steps",
           4.0 * angle * angle * std::sqrt(2.0 * contacts / 180.0),
           "4 standard deviations of contacts that begin and end inside a step", driftOfElasticPair(verlet)},
          {named(onset) + "energy of a bouncing pair, change over 1e7 steps",
           contacts * std::pow(angle, 4.0) / 8.0, "(w dt)^4/8 a contact, all of one sign",
           driftOfElasticPair(onset)}};
}

}  // namespace

std::vector<HardCase> contactCases() {
  return {{"pair 50 % of a diameter into each other", halfOverlapElastic},
          {"100 spheres, each 50 % into its neighbours", halfOverlapCluster},
          {"20 m/s on a stack, springs of 2,000 N/m: beyond what they hold", impactOnSoftStack},
          {"20 m/s on a stack, springs of 200,000 N/m", impactOnStiffStack},
          {"friction 0", frictionZero},
          {"friction 1", frictionOne},
          {"elastic pair, 1e7 steps", longElasticPair}};
}

}  // namespace bedmix::hard
