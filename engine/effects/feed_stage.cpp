// SPDX-License-Identifier: MIT
#include "engine/effects/feed_stage.h"

#include "engine/core/particle_list.h"
#include "engine/core/rng.h"
#include "engine/coupling/voidage.h"
#include "engine/dem/particle_solver.h"
#include "engine/gas/gas_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bedmix {

namespace {

/// Another one than those of the places at the start and of the sizes.
constexpr std::uint64_t ownSequence = 0x8cb92ba72f3d8dd7;
constexpr int attempts = 8;  // at finding room, a stretch

/// The time in which one falls a hundredth of a diameter from rest; of particles that weigh nothing, that in
/// which one comes in.
double intervalOf(const Scene& scene) {
  if (scene.gravity > 0.0) return std::sqrt(0.02 * particleRange(scene).smallest / scene.gravity);
  return feedRate(scene) > 0.0 ? 1.0 / feedRate(scene) : infinity;
}

}  // namespace

std::unique_ptr<EffectStage> FeedStage::make(const EffectContext& context) {
  if (!context.scene.effects.find<FeedSettings>()) return nullptr;
  return std::make_unique<FeedStage>(context);
}

FeedStage::FeedStage(const EffectContext& context)
    : context_(context),
      feed_(*context.scene.effects.find<FeedSettings>()),
      kinds_(particleKinds(context.scene)),
      room_(context.scene),
      interval_(intervalOf(context.scene)),
      streams_(feed_.streams.size()),
      next_(static_cast<std::int32_t>(context.solver.particles().size())) {}

PopulationChange FeedStage::exchange(double passed) {
  PopulationChange change;
  since_ += passed;
  if (since_ < (1.0 - 1e-9) * interval_) return change;
  findGone(change);
  for (std::size_t s = 0; s < streams_.size(); ++s) {
    streams_[s].owed += since_ * feed_.streams[s].rate;
    letIn(s, change);
  }
  since_ = 0.0;
  if (change.empty()) return change;
  if (context_.gas)
    exchangeInGas(change);
  else
    context_.solver.exchange(change);
  return change;
}

void FeedStage::exchangeInGas(const PopulationChange& change) {
  const Particles& particles = context_.solver.particles();
  VoidageField& voidage = *context_.voidage;
  voidage.update(particles.position, particles.radii);
  before_ = voidage.voidage();
  context_.solver.exchange(change);
  voidage.update(particles.position, particles.radii);
  context_.gas->replaceSolids(before_, voidage.voidage());
}

void FeedStage::findGone(PopulationChange& change) const {
  const Particles& particles = context_.solver.particles();
  const auto isOut = [&](Vec2 at) {
    return std::any_of(feed_.outlets.begin(), feed_.outlets.end(), [&](const FeedOutlet& box) {
      return at.x >= box.from && at.x <= box.to && at.y >= box.bottom && at.y <= box.top;
    });
  };
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (isOut(particles.position[i])) change.gone.push_back(context_.solver.roster().rowOf(particles.id[i]));
  std::sort(change.gone.begin(), change.gone.end());
}

void FeedStage::letIn(std::size_t s, PopulationChange& change) {
  const FeedStream& how = feed_.streams[s];
  for (Stream& stream = streams_[s]; stream.owed >= 1.0; stream.owed -= 1.0) {
    const std::size_t there = context_.solver.particles().size() - change.gone.size() + change.come.size();
    if (there >= static_cast<std::size_t>(feed_.most) || next_ == std::numeric_limits<std::int32_t>::max())
      return;
    const std::uint8_t kind = *kindNamed(context_.scene, how.species);
    Rng rng(context_.scene.seed ^ (ownSequence * static_cast<std::uint64_t>(next_)));
    const double diameter = diameterAt(kinds_[kind], rng.uniform());
    Newcomer newcomer{.id = next_,
                      .radius = 0.5 * diameter,
                      .mass = massOf(kinds_[kind], 0.5 * diameter),
                      .kind = kind,
                      .stream = s,
                      .position = {},
                      .velocity = {how.vx, how.vy}};
    if (!findRoom(s, change, newcomer)) return;
    change.come.push_back(newcomer);
    ++next_;
  }
}

bool FeedStage::findRoom(std::size_t s, const PopulationChange& change, Newcomer& newcomer) {
  const FeedStream& how = feed_.streams[s];
  const Particles& particles = context_.solver.particles();
  const Period& period = context_.solver.contacts().period();
  const double radius = newcomer.radius;
  struct Other {
    Vec2 position;
    double radius;
  };
  std::vector<Other> near;
  const auto look = [&](Vec2 at, double r) {
    if (std::abs(at.y - how.y) < r + radius) near.push_back({at, r});
  };
  for (std::size_t i = 0; i < particles.size(); ++i) look(particles.position[i], particles.radiusOf(i));
  for (const Newcomer& other : change.come) look(other.position, other.radius);

  for (int attempt = 0; attempt < attempts; ++attempt) {
    Rng rng(context_.scene.seed ^ (ownSequence * (s + 1)) ^ streams_[s].tries++);
    newcomer.position = {rng.uniform(how.from + radius, how.to - radius), how.y};
    const bool touches = std::any_of(near.begin(), near.end(), [&](const Other& other) {
      return norm(period.nearest(other.position - newcomer.position)) < other.radius + radius;
    });
    if (!touches && isWithinBed(newcomer)) return true;
  }
  return false;
}

bool FeedStage::isWithinBed(const Newcomer& newcomer) const {
  const Vec2 at = newcomer.position;
  if (at.y < floorHeight(context_.scene, at.x) || !room_.isFree(at, newcomer.radius)) return false;
  for (std::size_t w = 0; w < context_.solver.contacts().walls().size(); ++w)
    if (context_.solver.wallNow(w).distance(at) < newcomer.radius) return false;
  return true;
}

std::int64_t FeedStage::waiting() const {
  constexpr double most = 1e15;  // told apart
  double owed = 0.0;
  for (const Stream& stream : streams_) owed = std::min(most, owed + std::floor(stream.owed));
  return static_cast<std::int64_t>(owed);
}

void FeedStage::hashInto(StateHash& hash) const {
  hash.add(static_cast<std::uint64_t>(next_));
  hash.add(since_);
  for (const Stream& stream : streams_) hash.add(stream.owed);
}

void FeedStage::save(StateWriter& out) const {
  const Particles& particles = context_.solver.particles();
  out.put(next_);
  out.put(since_);
  for (const Stream& stream : streams_) {
    out.put(stream.owed);
    out.put(stream.tries);
  }
  out.putAll(particles.radii);
  out.putAll(particles.kinds);
}

bool FeedStage::load(StateReader& in) {
  Particles& particles = context_.solver.particles();
  if (!(in.get(next_) && in.get(since_) && since_ >= 0.0)) return false;
  const std::vector<std::int32_t>& ids = context_.solver.roster().ids();
  if (next_ < 0 || (!ids.empty() && next_ <= ids.back())) return false;
  for (Stream& stream : streams_)
    if (!(in.get(stream.owed) && in.get(stream.tries) && stream.owed >= 0.0)) return false;
  if (!(in.getAll(particles.radii) && in.getAll(particles.kinds))) return false;
  const ParticleRange range = particleRange(context_.scene);
  for (std::size_t i = 0; i < particles.kinds.size(); ++i) {
    const double diameter = 2.0 * particles.radii[i];
    if (particles.kinds[i] >= kinds_.size() || !(diameter >= range.smallest && diameter <= range.largest))
      return false;
    particles.masses[i] = massOf(kinds_[particles.kinds[i]], particles.radii[i]);
  }
  return true;
}

}  // namespace bedmix
