// SPDX-License-Identifier: MIT
#include "engine/dem/particle_solver.h"

#include "engine/dem/integrators.h"

#include <cmath>
#include <utility>

namespace bedmix {

namespace {

/// The first value of a bed that is not finite.
std::optional<DemTrouble> findNonFinite(const Particles& p, const char* stage) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto particle = static_cast<std::int64_t>(i);
    for (const double force : {p.fx[i], p.fy[i]})
      if (!std::isfinite(force)) return DemTrouble{particle, force, true, "drag"};
    for (const double value : {p.x[i], p.y[i], p.vx[i], p.vy[i], p.spin.empty() ? 0.0 : p.spin[i]})
      if (!std::isfinite(value)) return DemTrouble{particle, value, true, stage};
  }
  return std::nullopt;
}

template <class Integrator>
class Solver final : public ParticleSolver {
 public:
  Solver(const Scene& scene, Particles start, const std::vector<WallSegment>& walls)
      : ParticleSolver(scene, std::move(start), walls),
        integrator_(scene, bed_.particles.size()),
        maxOverlap_(scene.limits.maxOverlap) {}

  std::optional<DemTrouble> advance(std::int64_t steps) override {
    if (!begun_) {
      if (const auto trouble = findNonFinite(bed_.particles, "start")) return trouble;
      integrator_.begin(bed_);
      begun_ = true;
    }
    std::int64_t taken = 0;
    for (; taken < steps; ++taken) {
      if (!integrator_.step(bed_)) break;
      if (largestOverlap() > maxOverlap_)
        return DemTrouble{largestOverlapParticle(), largestOverlap(), false, "contacts", taken + 1};
    }
    std::optional<DemTrouble> trouble = findNonFinite(bed_.particles, "integrate");
    if (trouble) trouble->steps = taken;
    return trouble;
  }

 private:
  Integrator integrator_;
  double maxOverlap_;
  bool begun_ = false;
};

template <bool friction>
std::unique_ptr<ParticleSolver> makeSolver(const Scene& scene, Particles start,
                                           const std::vector<WallSegment>& walls) {
  if (scene.time.integrator == Integrator::rk4)
    return std::make_unique<Solver<RungeKutta4<friction>>>(scene, std::move(start), walls);
  return std::make_unique<Solver<VelocityVerlet<friction>>>(scene, std::move(start), walls);
}

}  // namespace

std::unique_ptr<ParticleSolver> ParticleSolver::make(const Scene& scene, Particles start,
                                                     const std::vector<WallSegment>& walls) {
  return scene.contacts.friction ? makeSolver<true>(scene, std::move(start), walls)
                                 : makeSolver<false>(scene, std::move(start), walls);
}

ParticleSolver::ParticleSolver(const Scene& scene, Particles start, const std::vector<WallSegment>& walls)
    : bed_{.particles = std::move(start),
           .neighbours = NeighbourList(scene.particles.diameter, walls),
           .history = {},
           .loads = {},
           .gravity = scene.gravity,
           .step = scene.time.step,
           .seconds = {}},
      pairLaw_(pairLaw(scene)),
      wallLaw_(wallLaw(scene)) {
  const std::size_t n = bed_.particles.size();
  bed_.history.reset(0, scene.contacts.friction.has_value());
  bed_.loads.fx.assign(n, 0.0);
  bed_.loads.fy.assign(n, 0.0);
  bed_.loads.torque.assign(bed_.particles.spin.size(), 0.0);
}

double ParticleSolver::kineticEnergy() const {
  const Particles& p = bed_.particles;
  double energy = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) energy += 0.5 * p.mass * (p.vx[i] * p.vx[i] + p.vy[i] * p.vy[i]);
  for (const double spin : p.spin) energy += 0.5 * p.inertia * spin * spin;
  return energy;
}

double ParticleSolver::potentialEnergy() const {
  double energy = 0.0;
  for (const double y : bed_.particles.y) energy += bed_.particles.mass * bed_.gravity * y;
  return energy;
}

double ParticleSolver::elasticEnergy() const {
  const Particles& p = bed_.particles;
  const NeighbourList& list = bed_.neighbours;
  double energy = 0.0;
  const auto add = [&](const SpringDashpot& law, Vec2 apart) {
    const double depth = law.reach - norm(apart);
    if (depth > 0.0) energy += 0.5 * law.stiffness * depth * depth;
  };
  for (const auto& [i, j] : list.pairs()) add(pairLaw_, {p.x[j] - p.x[i], p.y[j] - p.y[i]});
  for (const auto& [i, w] : list.wallPairs()) {
    const Vec2 centre{p.x[i], p.y[i]};
    Vec2 point;
    if (list.walls()[w].touchPoint(centre, point)) add(wallLaw_, point - centre);
  }
  for (const double spring : bed_.history.spring)
    energy += 0.5 * pairLaw_.tangentialStiffness * spring * spring;
  return energy;
}

void ParticleSolver::hashInto(StateHash& hash) const {
  const Particles& p = bed_.particles;
  for (const std::vector<double>* values : {&p.x, &p.y, &p.vx, &p.vy, &p.spin}) hash.add(*values);
  if (!bed_.history.hasSprings) return;
  const auto addSprings = [&](const std::vector<Candidate>& list, std::span<const std::int32_t> contacts,
                              std::size_t offset) {
    for (const std::int32_t k : contacts) {
      hash.add(static_cast<std::uint64_t>(list[k - offset].first));
      hash.add(static_cast<std::uint64_t>(list[k - offset].second));
      hash.add(bed_.history.spring[k]);
    }
  };
  addSprings(bed_.neighbours.pairs(), bed_.history.pairContacts(), 0);
  addSprings(bed_.neighbours.wallPairs(), bed_.history.wallContacts(), bed_.neighbours.pairs().size());
}

}  // namespace bedmix
