// SPDX-License-Identifier: MIT
#include "engine/dem/particle_solver.h"

#include "engine/core/particle_list.h"
#include "engine/dem/closing_speed.h"
#include "engine/dem/runge_kutta.h"
#include "engine/dem/verlet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace bedmix {

namespace {

/// The first value of a bed that is not finite, or so large that its square is not.
std::optional<DemTrouble> findNonFinite(const Particles& p, const char* stage) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::int64_t particle = p.id[i];
    if (!p.external.empty())
      for (const double force : {p.external[i].x, p.external[i].y, p.drag[i]})
        if (!std::isfinite(force)) return DemTrouble{particle, force, DemTrouble::Kind::nonFinite, "drag"};
    for (const double value : {p.position[i].x, p.position[i].y, p.velocity[i].x, p.velocity[i].y,
                               p.spin.empty() ? 0.0 : p.spin[i], dot(p.velocity[i], p.velocity[i])})
      if (!std::isfinite(value)) return DemTrouble{particle, value, DemTrouble::Kind::nonFinite, stage};
  }
  return std::nullopt;
}

ParticleSolver::Fastest findFastest(const Particles& p) {
  ParticleSolver::Fastest found;
  double largest = 0.0;  // square
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double square = dot(p.velocity[i], p.velocity[i]);
    if (square <= largest) continue;
    largest = square;
    found.particle = p.id[i];
  }
  found.speed = std::sqrt(largest);
  return found;
}

template <class Integrator>
class Solver final : public ParticleSolver {
 public:
  Solver(const Scene& scene, Particles start, const std::vector<WallSegment>& walls, ThreadTeam& team)
      : ParticleSolver(scene, std::move(start), walls, team),
        integrator_(scene, bed_),
        maxOverlap_(scene.limits.maxOverlap * particleRange(scene).smallest),
        diameter_(particleRange(scene).smallest) {}

  std::optional<DemTrouble> advance(std::int64_t steps) override {
    if (!begun_) {
      if (const auto trouble = findNonFinite(bed_.particles, "start")) return trouble;
      integrator_.begin(bed_);
      begun_ = true;
    }
    const StepOutcome outcome = integrator_.advance(bed_, steps, maxOverlap_);
    std::optional<DemTrouble> trouble;
    if (!outcome.finite) trouble = findNonFinite(bed_.particles, "integrate");
    if (!trouble) bed_.comeIn([this](std::size_t i) { return bed_.particles.position[i]; });
    if (!trouble && steps > 0 && deepestOverlap(bed_) > maxOverlap_)
      trouble = DemTrouble{largestOverlapParticle(), largestOverlap(), DemTrouble::Kind::overlap, "contacts"};
    fastest_ = findFastest(bed_.particles);
    const double way = fastest_.speed * (bed_.step / diameter_);
    if (!trouble && way > furthestInAStep)
      trouble = DemTrouble{fastest_.particle, way, DemTrouble::Kind::speed, "integrate"};
    if (trouble) trouble->steps = outcome.steps;
    return trouble;
  }

 private:
  void goOn() override { integrator_.goOn(bed_); }
  void relist() override { integrator_.relist(bed_); }

  Integrator integrator_;
  double maxOverlap_;  // m
  double diameter_;    // m
};

}  // namespace

std::unique_ptr<ParticleSolver> ParticleSolver::make(const Scene& scene, Particles start,
                                                     const std::vector<WallSegment>& walls,
                                                     ThreadTeam& team) {
  if (scene.time.integrator == Integrator::rk4)
    return std::make_unique<Solver<RungeKutta4>>(scene, std::move(start), walls, team);
  return std::make_unique<Solver<Verlet>>(scene, std::move(start), walls, team);
}

ParticleSolver::ParticleSolver(const Scene& scene, Particles start, const std::vector<WallSegment>& walls,
                               ThreadTeam& team)
    : bed_(scene, std::move(start), walls, team),
      pairLaw_(pairLaw(scene)),
      wallLaw_(wallLaw(scene)),
      effects_(contactEffects(scene)),
      roster_(bed_.particles.id),
      smallest_(particleRange(scene).smallest) {}

void ParticleSolver::exchange(const PopulationChange& change) {
  const std::vector<std::int32_t>& id = bed_.particles.id;
  std::vector<std::uint8_t> goes(id.size());
  for (const std::size_t row : change.gone) goes[row] = 1;
  std::vector<std::int32_t> places(id.size());
  std::int32_t kept = 0;
  for (std::size_t i = 0; i < id.size(); ++i) places[i] = goes[roster_.rowOf(id[i])] ? -1 : kept++;
  bed_.exchange(places, change.come);
  roster_ = Roster(bed_.particles.id);
  if (begun_) relist();
}

std::int64_t ParticleSolver::largestOverlapParticle() const {
  double deepest = 0.0;
  std::int64_t particle = -1;
  for (std::size_t b = 0; b < bed_.contacts.blocks(); ++b) {
    const ContactBlock& block = bed_.contacts.block(b);
    if (block.deepest > deepest) particle = block.deepestId;
    deepest = std::max(deepest, block.deepest);
  }
  return particle;
}

double ParticleSolver::closingSpeed(double span) {
  if (!begun_ && advance(0)) return std::numeric_limits<double>::infinity();
  return bedmix::closingSpeed(bed_, pairLaw_, wallLaw_, fastest_.speed, span);
}

std::int64_t ParticleSolver::contactCount() const {
  std::size_t touching = 0;
  for (std::size_t b = 0; b < bed_.contacts.blocks(); ++b) touching += bed_.contacts.block(b).touching;
  return static_cast<std::int64_t>(touching);
}

double ParticleSolver::kineticEnergy() const {
  const Particles& p = bed_.particles;
  double energy = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) energy += 0.5 * p.massOf(i) * dot(p.velocity[i], p.velocity[i]);
  for (std::size_t i = 0; i < p.spin.size(); ++i) energy += 0.5 * p.inertiaOf(i) * p.spin[i] * p.spin[i];
  return energy;
}

double ParticleSolver::potentialEnergy() const {
  double energy = 0.0;
  const Particles& p = bed_.particles;
  for (std::size_t i = 0; i < p.size(); ++i) energy += p.massOf(i) * bed_.gravity * p.position[i].y;
  return energy;
}

double ParticleSolver::elasticEnergy() const {
  const Particles& p = bed_.particles;
  const std::vector<Vec2>& position = p.position;
  double energy = 0.0;
  // Returns the tangential spring, N/m, of a contact that overlaps by `depth`, with effective radius.
  const auto add = [&](const SpringDashpot& law, double depth, double radius) {
    if (depth <= 0.0) return law.tangentialStiffness;
    if (!effects_ || !effects_->hertz) {
      energy += 0.5 * law.stiffness * depth * depth;
      return law.tangentialStiffness;
    }
    const double stiffness = effects_->spring * std::sqrt(radius * depth);
    energy += 0.4 * stiffness * depth * depth;
    return effects_->tangentialSpring * stiffness;
  };
  const auto addSpring = [&](const ContactSlots& slots, std::size_t c, double stiffness) {
    if (!slots.spring.empty()) energy += 0.5 * stiffness * slots.spring[c] * slots.spring[c];
  };
  for (std::size_t b = 0; b < bed_.contacts.blocks(); ++b) {
    const ContactBlock& block = bed_.contacts.block(b);
    for (const ContactSlots* slots : {&block.near, &block.crossing})
      for (std::size_t c = 0; c < slots->count; ++c) {
        const std::int32_t i = slots->first[c], j = slots->second[c];
        const double first = p.radiusOf(i), second = p.radiusOf(j);
        const double depth = first + second - norm(bed_.contacts.period().nearest(position[j] - position[i]));
        addSpring(*slots, c, add(pairLaw_, depth, first * second / (first + second)));
      }
    for (const ContactBlock::AtWall& w : block.walls)
      for (std::size_t c = 0; c < w.slots.count; ++c) {
        const std::int32_t i = w.slots.first[c];
        Vec2 point;
        const bool isMet =
            bed_.contacts.walls()[w.wall].at(bed_.timeAfter(0.0)).touchPoint(position[i], point);
        const double depth = isMet ? p.radiusOf(i) - norm(point - position[i]) : 0.0;
        addSpring(w.slots, c, add(wallLaw_, depth, p.radiusOf(i)));
      }
  }
  return energy;
}

void ParticleSolver::hashInto(StateHash& hash) const {
  const Particles p = inOrderOfIds(bed_.particles);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (const double value : {p.position[i].x, p.position[i].y, p.velocity[i].x, p.velocity[i].y})
      hash.add(value);
  hash.add(p.spin);

  // What contacts remember, by ids, or an id and -1 - wall.
  std::vector<std::tuple<std::int64_t, std::int64_t, double>> springs;
  const auto collect = [&](const ContactSlots& slots, auto&& other) {
    for (const std::vector<double>* column : {&slots.spring, &slots.rolled, &slots.bridge})
      for (std::size_t c = 0; c < slots.count && !column->empty(); ++c) {
        const double value = (*column)[c];
        if (value == 0.0) continue;
        const std::int64_t a = bed_.particles.id[slots.first[c]], b = other(c);
        // How far the first has rolled on the second is minus how far the second has on the first.
        springs.emplace_back(std::max(a, b), std::min(a, b),
                             column == &slots.rolled && a < b ? -value : value);
      }
  };
  for (std::size_t b = 0; b < bed_.contacts.blocks(); ++b) {
    const ContactBlock& block = bed_.contacts.block(b);
    for (const ContactSlots* slots : {&block.near, &block.crossing})
      collect(*slots, [&](std::size_t c) { return bed_.particles.id[slots->second[c]]; });
    for (const ContactBlock::AtWall& w : block.walls)
      collect(w.slots, [&](std::size_t) { return -1 - static_cast<std::int64_t>(w.wall); });
  }
  std::sort(springs.begin(), springs.end());
  for (const auto& [a, b, spring] : springs) {
    hash.add(static_cast<std::uint64_t>(a));
    hash.add(static_cast<std::uint64_t>(b));
    hash.add(spring);
  }
}

void ParticleSolver::save(StateWriter& out) const {
  out.put(static_cast<std::uint8_t>(begun_));
  bed_.save(out, begun_);
}

bool ParticleSolver::load(StateReader& in) {
  std::uint8_t begun = 0;
  if (!in.get(begun) || begun > 1 || !bed_.load(in, begun == 1)) return false;
  roster_ = Roster(bed_.particles.id);
  begun_ = begun == 1;
  if (begun_) goOn();
  fastest_ = findFastest(bed_.particles);
  return true;
}

}  // namespace bedmix
