// SPDX-License-Identifier: MIT
#include "app/effect_prices.h"

#include "engine/core/particle_list.h"
#include "engine/core/quantile.h"
#include "engine/core/rng.h"
#include "engine/core/scene_reader.h"
#include "engine/core/walls.h"
#include "engine/dem/particles.h"
#include "engine/effects/effects.h"
#include "engine/simulation.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace bedmix {

namespace {

constexpr int turns = 5;                        // of which the median counts
constexpr std::int64_t fewestSteps = 20;        // in a turn
constexpr double turnSeconds = 0.02;            // of wall time, at least
constexpr std::int64_t mostPriced = 50000;      // with which that is a moment
constexpr double spacing = 0.999, stir = 0.05;  // diameters; m/s

/// The scene without some tables; none where it cannot be.
std::optional<Scene> without(const Scene& scene, const std::vector<std::string_view>& tables) {
  std::vector<Override> removed;
  for (const std::string_view table : tables) removed.push_back({std::string(table), ""});
  const bool losesKinds = std::find(tables.begin(), tables.end(), "particles.species") != tables.end();
  if (losesKinds && !scene.contacts.pairs.empty()) removed.push_back({"contacts.pairs", ""});
  Result<Scene> changed = readScene(writeScene(scene), scene.name, removed);
  if (!changed) return std::nullopt;
  return std::move(*changed);
}

/// Side by side from the floor up, each touching its neighbours, and stirred a little.
Particles pack(const Scene& scene) {
  const double d = spacing * particleRange(scene).largest;
  double bottom = 0.0;
  for (const WallSegment& wall : bedWalls(scene))
    for (const double y : {wall.a.y, wall.b.y})
      if (y < scene.bed.height) bottom = std::max(bottom, y);
  const auto columns = std::max<std::int64_t>(1, static_cast<std::int64_t>(scene.bed.width / d));
  std::vector<Vec2> places;
  for (std::int64_t i = 0; i < scene.particles.count; ++i)
    places.push_back({(static_cast<double>(i % columns) + 0.5) * d,
                      bottom + (static_cast<double>(i / columns) + 0.5) * d});
  Particles particles = makeParticles(scene, places);
  Rng rng(scene.seed);
  for (Vec2& v : particles.velocity) v = {rng.uniform(-stir, stir), rng.uniform(-stir, stir)};
  return particles;
}

/// A bed that is run for a moment again and again.
class Trial {
 public:
  explicit Trial(const Scene& scene) : simulation_(Simulation::make(scene, pack(scene))) {
    const bool isCounted = !scene.time.step.isAutomatic();
    const std::int64_t gas = scene.gas && !scene.gas->step.isAutomatic() ? stepsPerGasStep(scene) : 1;
    const std::int64_t tried =
        isCounted ? fewestSteps : std::llround(std::ceil(contactTimeScale(scene) / tick(scene)));
    batch_ = (tried + gas - 1) / gas * gas;
    particles_ = static_cast<double>(scene.particles.count);
  }

  /// Runs it for one turn; false where the bed breaks.
  bool run() {
    const auto start = std::chrono::steady_clock::now();
    const std::int64_t before = simulation_.particleSteps();
    double elapsed = 0.0;
    do {
      if (simulation_.advance(batch_)) return false;
      elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    } while (elapsed < turnSeconds);
    const auto steps = static_cast<double>(simulation_.particleSteps() - before);
    nanoseconds_.push_back(1e9 * elapsed / (steps * particles_));
    return true;
  }
  double nanoseconds() const {
    std::vector<double> sorted = nanoseconds_;
    std::sort(sorted.begin(), sorted.end());
    return quantile(sorted, 0.5);
  }
  double contacts() const { return static_cast<double>(simulation_.contacts()) / particles_; }

 private:
  Simulation simulation_;
  std::int64_t batch_ = 0;
  double particles_ = 0.0;
  std::vector<double> nanoseconds_;
};

/// The scene without an effect, and without one more where that one needs it.
struct Lesser {
  EffectPrice price;
  std::optional<Scene> scene;
};
Lesser withoutEffect(const Scene& scene, const EffectInfo& effect) {
  Lesser lesser{{std::string(effect.name), std::nullopt, ""}, without(scene, {effect.table})};
  for (const EffectInfo& other : effectTable()) {
    if (lesser.scene) break;
    if (!other.isOn(scene) || other.table == effect.table) continue;
    lesser.scene = without(scene, {effect.table, other.table});
    if (lesser.scene) lesser.price.with = other.name;
  }
  return lesser;
}

}  // namespace

std::optional<EffectPrices> measureEffectPrices(const Scene& asked) {
  if (asked.particles.count == 0 || asked.particles.count > mostPriced) return std::nullopt;
  Scene scene = asked;
  scene.pictures.reset();  // which may show an effect, as may what is tracer
  scene.tracer = {};
  scene.limits.maxOverlap = scene.limits.warnOverlap = 1.0;
  std::vector<Lesser> lessers;
  std::vector<Trial> trials;
  trials.emplace_back(scene);
  for (const EffectInfo& effect : effectTable()) {
    if (!effect.isOn(scene)) continue;
    Lesser lesser = withoutEffect(scene, effect);
    if (lesser.scene) trials.emplace_back(*lesser.scene);
    lessers.push_back(std::move(lesser));
  }
  for (int turn = 0; turn < turns; ++turn)
    for (Trial& trial : trials)
      if (!trial.run()) return std::nullopt;

  EffectPrices prices{trials.front().nanoseconds(), trials.front().contacts(), {}};
  std::size_t tried = 1;
  for (Lesser& lesser : lessers) {
    if (lesser.scene) lesser.price.nanoseconds = prices.whole - trials[tried++].nanoseconds();
    prices.effects.push_back(std::move(lesser.price));
  }
  return prices;
}

}  // namespace bedmix
