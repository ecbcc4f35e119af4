// SPDX-License-Identifier: MIT
#include "engine/dem/packing.h"

#include "engine/core/particle_list.h"
#include "engine/core/rng.h"
#include "engine/core/walls.h"
#include "engine/dem/particle_solver.h"
#include "engine/dem/particle_step.h"
#include "engine/dem/room.h"
#include "engine/dem/wall_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace bedmix {

namespace {

constexpr double siteOverDiameter = 1.25;
constexpr double sitesPerParticle = 1.1;
constexpr double leastSite = 1.01;   // of a diameter
constexpr double mostRows = 1e6;     // of sites among obstacles
constexpr double restSpeed = 1e-3;   // m/s
constexpr double restTime = 0.02;    // s
constexpr double longestFall = 3.0;  // s
constexpr double restError = 0.01;   // of steps that are chosen, at most: with more a bed may not rest
constexpr double viscosity = 10.0;   // 1/s
constexpr double glance = 1e-4;      // s, between looks at whether they rest; T where steps are chosen

/// Square sites side by side over the bed's width, from `bottom` up.
struct Lattice {
  double bottom = 0.0;  // m
  double width = 0.0;   // m, of a site
  double height = 0.0;  // m
  std::int64_t columns = 0;
  std::int64_t rows = 0;
  std::vector<std::int64_t> sites;  // that are free, row by row
};

double highestFloor(const Scene& scene) {
  double highest = 0.0;
  const double top = scene.bed.height;  // side walls and lid reach it or go beyond, the floor does not
  for (const WallSegment& wall : bedWalls(scene))
    for (const double y : {wall.a.y, wall.b.y})
      if (y < top) highest = std::max(highest, y);
  return highest;
}

/// Room below the lid, or below the top of a drum, for so many rows at most.
double rowsBelowTop(const Scene& scene, const Room& room, double bottom, double height) {
  double top = infinity;
  if (scene.bed.top == BedTop::lid) top = scene.bed.height;
  if (room.drum()) top = std::min(top, room.drum()->a.y + room.drum()->radius);
  return std::floor((top - bottom) / height);
}

/// Lays rows until as many sites as wanted are free, no more than `most` of them.
void findSites(Lattice& lattice, const Room& room, double diameter, double wanted, double most) {
  // Wherever in its site a particle is put.
  const double reach = diameter / 2.0 + std::hypot(lattice.width - diameter, lattice.height - diameter) / 2.0;
  lattice.sites.clear();
  lattice.rows = 0;
  while (static_cast<double>(lattice.sites.size()) < wanted && static_cast<double>(lattice.rows) < most) {
    for (std::int64_t c = 0; c < lattice.columns; ++c) {
      const Vec2 middle{(static_cast<double>(c) + 0.5) * lattice.width,
                        lattice.bottom + (static_cast<double>(lattice.rows) + 0.5) * lattice.height};
      if (room.isFree(middle, reach)) lattice.sites.push_back(lattice.rows * lattice.columns + c);
    }
    ++lattice.rows;
  }
}

/// Sites for all particles; none where even the closest lattice below the lid or in the drum has too few.
std::optional<Lattice> layLattice(const Scene& scene) {
  const double d = particleRange(scene).largest;
  const Room room(scene);
  double bottom = std::max(highestFloor(scene), scene.start.above.value_or(0.0));
  if (room.drum()) bottom = std::max(bottom, room.drum()->a.y - room.drum()->radius);
  const auto count = static_cast<double>(scene.particles.count);
  const double wanted = std::ceil(sitesPerParticle * count);
  for (double site = siteOverDiameter; site >= leastSite; site -= 0.01) {
    const double columns = std::floor(scene.bed.width / (site * d));
    if (columns < 1.0) continue;
    Lattice lattice{bottom, scene.bed.width / columns, site * d, std::llround(columns), 0, {}};
    const double most = rowsBelowTop(scene, room, bottom, lattice.height);
    if (room.isAll()) {
      lattice.rows = std::llround(std::min(std::ceil(wanted / columns), most));
      lattice.sites.resize(static_cast<std::size_t>(lattice.columns * lattice.rows));
      std::iota(lattice.sites.begin(), lattice.sites.end(), std::int64_t{0});
    } else {
      findSites(lattice, room, d, wanted, std::min(most, mostRows));
    }
    if (static_cast<double>(lattice.sites.size()) >= count) return lattice;
  }
  return std::nullopt;
}

std::vector<Vec2> scatter(const Scene& scene, const Lattice& lattice) {
  Rng rng(scene.seed);
  std::vector<std::int64_t> sites = lattice.sites;
  const double d = particleRange(scene).largest;
  std::vector<Vec2> positions;
  for (std::int64_t i = 0; i < scene.particles.count; ++i) {
    // One step of a Fisher-Yates shuffle: a site at random among those that are left.
    const std::size_t left = sites.size() - i;
    std::swap(sites[i], sites[i + static_cast<std::size_t>(rng.uniform() * static_cast<double>(left))]);
    const double column = static_cast<double>(sites[i] % lattice.columns);
    const double row = static_cast<double>(sites[i] / lattice.columns);
    const double x = d / 2.0 + column * lattice.width + rng.uniform() * (lattice.width - d);
    const double y = d / 2.0 + row * lattice.height + rng.uniform() * (lattice.height - d);
    positions.push_back({x, lattice.bottom + y});
  }
  return positions;
}

/// Lets the particles fall and come to rest.
std::optional<DemTrouble> settle(const Scene& scene, ParticleSolver& solver) {
  std::optional<ParticleStep> chosen;
  if (scene.time.step.isAutomatic()) chosen.emplace(scene);
  Particles& p = solver.particles();
  p.addExternalForces();
  for (std::size_t i = 0; i < p.size(); ++i) p.drag[i] = viscosity * p.massOf(i);
  const std::int64_t given = chosen ? 0 : std::max<std::int64_t>(1, std::llround(glance / scene.time.step));
  const double interval = chosen ? contactTimeScale(scene) : static_cast<double>(given) * scene.time.step;
  double atRest = 0.0;  // s
  for (double time = 0.0; time < longestFall && atRest < restTime; time += interval) {
    if (const auto trouble = chosen ? chosen->advance(interval, solver).trouble : solver.advance(given))
      return trouble;
    double fastest = 0.0;  // square
    for (const Vec2 v : p.velocity) fastest = std::max(fastest, dot(v, v));
    atRest = fastest < restSpeed * restSpeed ? atRest + interval : 0.0;
  }
  return std::nullopt;
}

const char* what(DemTrouble::Kind kind) {
  switch (kind) {
    case DemTrouble::Kind::nonFinite:
      return "a coordinate";
    case DemTrouble::Kind::overlap:
      return "overlap over diameter";
    case DemTrouble::Kind::speed:
      break;
  }
  return "way in a step over diameter";
}

}  // namespace

Result<Particles> packBed(const Scene& scene, ThreadTeam& team) {
  const std::optional<Lattice> lattice = layLattice(scene);
  if (!lattice)
    return Diagnostic(
        {}, fmt::format("particles.count: {} spheres of {} m do not fit above the floor and between "
                        "the obstacles; take fewer, or a wider bed, or with a lid a higher one",
                        scene.particles.count, scene.particles.diameter));
  Particles start = makeParticles(scene, scatter(scene, *lattice));
  if (scene.start.arrangement == Arrangement::drop || start.size() == 0) return start;

  Scene calm = scene;
  calm.floor.vibration.reset();
  for (ObstacleSettings& obstacle : calm.obstacles) obstacle.spinRpm.reset();
  if (!scene.time.step.isAutomatic()) calm.time.integrator = Integrator::velocityVerlet;
  calm.time.error = std::min(calm.time.error, restError);
  const auto solver = ParticleSolver::make(calm, std::move(start), allWalls(calm), team);
  if (const auto trouble = settle(calm, *solver))
    return Diagnostic({},
                      fmt::format("start: while the bed settled, {} of particle {} became {:.3g} ({}); "
                                  "take a smaller time.step or a larger contacts.stiffness",
                                  what(trouble->kind), trouble->particle, trouble->value, trouble->stage),
                      Trouble::solution);
  return makeParticles(scene, inOrderOfIds(solver->particles()).position);
}

}  // namespace bedmix
