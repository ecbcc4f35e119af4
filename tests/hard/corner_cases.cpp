// SPDX-License-Identifier: MIT
#include "tests/hard/hard_beds.h"
#include "tests/hard/hard_case.h"

namespace bedmix::hard {

namespace {

constexpr const char* balance = "balance of forces; no swing is left";
constexpr double left = 1e-9;  // of the force, after more than 40 decay times of the swing

Scene stairScene() {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  scene.floor = {18.0, FloorShape::stair};
  scene.gas.emplace();
  scene.gas->grid.columns = {{8, 0.012}};
  scene.gas->grid.rows = {{15, 0.012}, {12, 0.020}};
  return scene;
}

/// Where a sphere ends that starts at `at` and is pushed by `push` (N) beside its weight.
Vec2 restOf(const Scene& scene, Vec2 at, Vec2 push, const std::vector<WallSegment>& walls,
            std::int64_t steps = 100000) {
  Particles start = makeParticles(scene, {at});
  start.addExternalForces();
  start.external[0] = push;
  const auto solver = ParticleSolver::make(scene, std::move(start), walls);
  go(*solver, steps);
  return solver->particles().position[0];
}

// The stair's first riser stands at x = 24 mm and is 12 mm high.
std::vector<Check> stairCorner() {
  const Scene scene = stairScene();
  const double w = particleMass(scene) * scene.gravity, k = normalStiffness(scene);
  const Vec2 at = restOf(scene, {0.022, 0.002}, {3.0 * w, 0.0}, bedWalls(scene));
  return {
      {"push of the riser over 3 weights, less 1", left, balance,
       std::abs((at.x + 0.002 - 0.024) * k / (3.0 * w) - 1.0)},
      {"push of the tread over the weight, less 1", left, balance, std::abs((0.002 - at.y) * k / w - 1.0)}};
}

// On the bisector of the edge, pressed into it: neither tread nor riser has its foot there, one corner does.
// What leaves the bisector grows by e^12 in the 0.1 s, as on any edge.
std::vector<Check> stairEdge() {
  const Scene scene = stairScene();
  const double w = particleMass(scene) * scene.gravity, k = normalStiffness(scene);
  const double slant = std::sqrt(0.5), force = 3.0 * w;
  const Vec2 edge{0.024, 0.012}, away{-slant, slant};
  const Vec2 at =
      restOf(scene, edge + (0.002 - force / k) * away, Vec2{0.0, w} - force * away, bedWalls(scene), 10000);
  return {{"push of the edge over 3 weights, less 1", left, balance,
           std::abs((0.002 - norm(at - edge)) * k / force - 1.0)},
          {"off the bisector, m", 1e-10, "round-off of the place, grown by e^12",
           std::abs(dot(at - edge, {slant, slant}))}};
}

std::vector<Check> sharpCorner() {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  scene.floor.inclinationDeg = 60.0;
  const double w = particleMass(scene) * scene.gravity, k = normalStiffness(scene), r = 0.002;
  const Vec2 up{-std::sin(pi / 3.0), std::cos(pi / 3.0)};  // of the incline
  const Vec2 at = restOf(scene, {r, (r + std::sin(pi / 3.0) * r) / std::cos(pi / 3.0)}, {}, bedWalls(scene));
  return {{"push of the incline over 2 weights, less 1", left, balance,
           std::abs((r - dot(at, up)) * k / (2.0 * w) - 1.0)},
          {"push of the wall over sqrt(3) weights, less 1", left, balance,
           std::abs((r - at.x) * k / (std::sqrt(3.0) * w) - 1.0)}};
}

// Two risers 2 % closer than a diameter, and the tread below.
std::vector<Check> betweenSteps() {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  const double w = particleMass(scene) * scene.gravity, k = normalStiffness(scene), d = 0.004;
  const double gap = 0.98 * d;
  const Vec2 chain[] = {{-0.01, 0.012}, {0.0, 0.012}, {0.0, 0.0}, {gap, 0.0}, {gap, 0.012}, {0.05, 0.012}};
  std::vector<WallSegment> walls;
  for (int c = 0; c + 1 < 6; ++c) walls.push_back({chain[c], chain[c + 1], true, false});
  const Vec2 at = restOf(scene, {0.499 * gap, 0.006}, {}, walls);
  return {
      {"off the middle of the gap, of its overlap", left, balance, std::abs(at.x / (0.5 * gap) - 1.0) / 0.01},
      {"push of the tread over the weight, less 1", left, balance, std::abs((d / 2.0 - at.y) * k / w - 1.0)}};
}

// A wall's free end points up; each of the two contacts of a point has no radius of its own.
std::vector<Check> wallEnd() {
  Scene scene = smoothSpheres();
  scene.gravity = 9.81;
  const double w = particleMass(scene) * scene.gravity, k = normalStiffness(scene);
  const std::vector<WallSegment> posts{{{0.0, 0.0}, {0.0, 0.05}}, {{0.003, 0.0}, {0.003, 0.05}}};
  const Vec2 at = restOf(scene, {0.0015, 0.0514}, {}, posts);
  const Vec2 end{0.0, 0.05};
  // Each carries half, along the line from its end.
  const double slope = (at.y - end.y) / norm(at - end);
  return {{"upward push of both ends over the weight, less 1", left, balance,
           std::abs(2.0 * (0.002 - norm(at - end)) * k * slope / w - 1.0)},
          {"off the middle between them, m", left * w / k, balance, std::abs(at.x - 0.0015)}};
}

}  // namespace

std::vector<HardCase> cornerCases() {
  return {{"wedged in the stair's corner", stairCorner},
          {"on the stair's edge", stairEdge},
          {"wedged between wall and incline, 30 deg", sharpCorner},
          {"between two steps 0.98 d apart", betweenSteps},
          {"on two wall end points 0.75 d apart", wallEnd}};
}

}  // namespace bedmix::hard
