// SPDX-License-Identifier: MIT
#include "tests/hard/hard_beds.h"
#include "tests/hard/hard_case.h"

#include <limits>

namespace bedmix::hard {

namespace {

Scene heavySpheres() {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  return scene;
}
double weight(const Scene& scene) { return particleMass(scene) * scene.gravity; }

/// Heights of a stack at rest: each contact carries what stands above it.
std::vector<Vec2> stackAtRest(const Scene& scene, int count, double x) {
  const double sag = weight(scene) / normalStiffness(scene);
  std::vector<Vec2> positions;
  double y = -scene.particles.diameter / 2.0;
  for (int i = 0; i < count; ++i) {
    y += scene.particles.diameter - (count - i) * sag;
    positions.push_back({x, y});
  }
  return positions;
}

// Leans on a wall with half of each sphere's weight: without, a column of spheres has nothing to stand by.
std::vector<Check> column() {
  Scene scene = heavySpheres();
  scene.contacts.friction.emplace();
  constexpr int count = 200, steps = 6'000'000;
  const double lean = 0.5 * weight(scene), r = scene.particles.diameter / 2.0;
  const std::vector<Vec2> rest = stackAtRest(scene, count, r - lean / normalStiffness(scene));
  const std::vector<WallSegment> corner{{{0.0, 2.0}, {0.0, 0.0}, true, false}, {{0.0, 0.0}, {1.0, 0.0}}};
  Particles start = makeParticles(scene, rest);
  start.addExternalForces();
  start.external.assign(count, {-lean, 0.0});
  const auto solver = ParticleSolver::make(scene, std::move(start), corner);
  go(*solver, steps);
  const Particles p = inOrderOfIds(solver->particles());
  double creep = 0.0;
  for (int i = 0; i < count; ++i) creep = std::max(creep, norm(p.position[i] - rest[i]));
  const double ulp = std::numeric_limits<double>::epsilon() * rest.back().y;
  return {{"creep in 60 s, m", steps * ulp, "a unit in the last place of the height a step", creep},
          {"fastest sphere after 60 s, m/s", std::sqrt(6e6) * ulp * 2.0 * pairAngle(scene) / scene.time.step,
           "as many units, at random, at the fastest frequency", fastest(p)}};
}

Check stackOfTen(double stiffness, Integrator integrator) {
  Scene scene = heavySpheres();
  scene.time.integrator = integrator;
  scene.contacts.stiffness = stiffness;
  scene.time.step = contactTimeScale(scene) / 14.0;
  constexpr int count = 10;
  std::vector<Vec2> touching;
  for (int i = 0; i < count; ++i) touching.push_back({0.0, (0.5 + i) * scene.particles.diameter});
  const auto solver = solverAt(scene, touching, wideFloor());
  // The slowest swing of a chain that stands on its end, and its decay.
  const double w = std::sqrt(stiffness / particleMass(scene)) * 2.0 * std::sin(pi / (4.0 * count + 2.0));
  const double decay = pairDamping(scene) / (2.0 * stiffness) * w * w;
  go(*solver, std::llround(20.0 / decay / scene.time.step));
  const Particles p = inOrderOfIds(solver->particles());
  const double sag = weight(scene) / stiffness, d = scene.particles.diameter;
  double worst = 0.0;
  for (int i = 0; i < count; ++i) {
    const double depth = d - (p.position[i].y - (i == 0 ? -d / 2.0 : p.position[i - 1].y));
    worst = std::max(worst, std::abs(depth / sag - (count - i)));
  }
  return {fmt::format("{}{:g} N/m, step T/14: overlaps of ten spheres, in m g/k", named(scene), stiffness),
          1e-6, "n m g/k; of the first swing e^-20 is left", worst};
}

std::vector<Check> stiffnesses() {
  return {stackOfTen(200.0, Integrator::velocityVerlet), stackOfTen(200000.0, Integrator::velocityVerlet),
          stackOfTen(2000.0, Integrator::verletOnset)};
}

std::vector<Check> pressed() {
  Scene scene = heavySpheres();
  scene.limits.maxOverlap = 0.2;
  Particles start = makeParticles(scene, stackAtRest(scene, 2, 0.0));
  start.addExternalForces();
  start.external[1] = {0.0, -1000.0 * weight(scene)};
  const auto solver = ParticleSolver::make(scene, std::move(start), wideFloor());
  go(*solver, 200000);
  const Particles p = inOrderOfIds(solver->particles());
  const double sag = 1002.0 * weight(scene) / normalStiffness(scene), r = p.radius;
  return {{"deepest contact over that of 1,002 weights at rest", 1.0 + 3.0 / std::sqrt(5.0),
           "both swings of two equal masses on two equal springs at once",
           solver->largestOverlap() * 2.0 * r / sag},
          {"overlap with the floor over that of 1,002 weights, less 1", 1e-9, "no swing is left after 2 s",
           std::abs((r - p.position[0].y) / sag - 1.0)}};
}

void addCrystal(std::vector<Check>& checks, double ofScale, Integrator integrator) {
  Scene scene = heavySpheres();
  scene.time.integrator = integrator;
  scene.contacts.friction.emplace();
  scene.time.step = contactTimeScale(scene) / ofScale;
  constexpr int columns = 12, rows = 16;
  const double d = scene.particles.diameter;
  const std::vector<Vec2> sites = hexagonal(d, columns, rows);
  const auto solver = solverAt(scene, sites, closedBox(columns * d, 0.2));
  go(*solver, 0);
  const double start = energy(*solver);
  double highest = 0.0;
  for (int k = 0; k < 100; ++k) {
    go(*solver, std::llround(0.02 / scene.time.step));
    highest = std::max(highest, energy(*solver) / start);
  }
  const Particles p = inOrderOfIds(solver->particles());
  double moved = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) moved = std::max(moved, norm(p.position[i] - sites[i]) / d);
  const std::string what = fmt::format("{}step T/{:g}: ", named(scene), ofScale);
  checks.push_back(
      {what + "largest energy over that at the start", 1.0, "dashpots and friction only take", highest});
  checks.push_back({what + "furthest from its site after 2 s, d",
                    rows * (rows + 1) * weight(scene) / normalStiffness(scene) / d,
                    "2 x the sag of a chain of 16", moved});
}

std::vector<Check> crystal() {
  std::vector<Check> checks;
  for (const double ofScale : {100.0, 14.0}) addCrystal(checks, ofScale, Integrator::velocityVerlet);
  addCrystal(checks, 14.0, Integrator::verletOnset);
  return checks;
}

}  // namespace

std::vector<HardCase> restCases() {
  return {{"column of 200, 60 s", column},
          {"stiffness 200 and 200,000 N/m", stiffnesses},
          {"sphere under 1,000 times its weight", pressed},
          {"hexagonal crystal", crystal}};
}

}  // namespace bedmix::hard
