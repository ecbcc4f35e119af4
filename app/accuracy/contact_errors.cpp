// SPDX-License-Identifier: MIT
#include "app/accuracy/contact_errors.h"

#include "app/accuracy/damped_contact.h"
#include "app/accuracy/scene_steps.h"
#include "app/accuracy/start_states.h"
#include "engine/simulation.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace bedmix {

namespace {

constexpr int phases = 32;         // of a step at which contacts begin
constexpr int lengths = 5;         // of a fixed step, so that contacts end at all phases, too
constexpr double spread = 0.04;    // of them, relative
constexpr double interior = 0.16;  // of T: within the contact of a pair, which takes 0.35 T

/// Typical of a bed; the law is linear, so that a fixed step errs by the same share at any speed.
double approachSpeed(const Scene& scene) {
  return std::sqrt((scene.gravity > 0.0 ? scene.gravity : 9.81) * scene.particles.diameter);
}

/// A narrow empty bed with room for spheres one above the other.
Scene emptyBed(const Scene& like) {
  Scene scene = like;
  scene.gas.reset();
  scene.flux.reset();
  scene.gravity = 0.0;
  scene.floor = {};
  scene.contacts.friction.reset();
  scene.bed.width = 10.0 * scene.particles.diameter;
  scene.bed.height = 3.0 * phases * scene.particles.diameter;
  scene.bed.top = BedTop::open;
  return scene;
}

class RootMeanSquare {
 public:
  void add(double error) {
    sum_ += error * error, ++n_;
    worst_ = std::max(worst_, std::abs(error));
  }
  double value() const { return std::sqrt(sum_ / n_); }
  double worst() const { return worst_; }

 private:
  double sum_ = 0.0, worst_ = 0.0;
  int n_ = 0;
};

class Collisions {
 public:
  explicit Collisions(const Scene& like)
      : scene_(emptyBed(like)),
        d_(scene_.particles.diameter),
        speed_(approachSpeed(like)),
        pair_{0.5 * particleMass(scene_), normalStiffness(scene_), pairDamping(scene_)},
        wall_{particleMass(scene_), normalStiffness(scene_), wallDamping(scene_)} {}

  void measure(Sample& into) {
    if (!pair_.rebounds() || !wall_.rebounds()) return;
    for (const StepLength length : stepLengths()) {
      Scene scene = scene_;
      scene.time.step = length;
      headOn(scene, false);
      headOn(scene, true);
    }
    into.set(measure::restitution, rebound_.value());
    into.set(measure::worstRestitution, rebound_.worst());
    into.set(measure::duration, duration_.value());
    into.set(measure::interior, within());
  }
  void measureSliding(const FrictionSettings& friction, Sample& into) {
    if (!wall_.rebounds()) return;
    RootMeanSquare error;
    for (const StepLength length : stepLengths()) {
      Scene scene = scene_;
      scene.time.step = length;
      scene.contacts.friction = friction;
      const double exact = friction.coefficient * wall_.grossImpulse() * speed_ / particleMass(scene);
      const double slip = 10.0 * speed_;
      const FramePtr after = run(scene, placesAtWall(scene), [&](Particles& p, std::size_t i) {
        p.velocity[i] = {-speed_, slip};
      });
      for (const Vec2f v : after->velocity) error.add((slip - v.y) / exact - 1.0);
    }
    into.set(measure::oblique, error.value());
  }

 private:
  /// Steps to try; the scene's own where it is chosen.
  std::vector<StepLength> stepLengths() const {
    if (scene_.time.step.isAutomatic()) return {scene_.time.step};
    std::vector<StepLength> list;
    const double step = scene_.time.step;
    for (int k = 0; k < lengths; ++k) list.push_back(step * (1.0 + spread * (2.0 * k / (lengths - 1) - 1.0)));
    return list;
  }
  /// Way to go until touch, m.
  double gap(const Scene& scene, int k) const {
    return speed_ * longestTaken(scene) * (1.0 + (k + 0.5) / phases);
  }
  double height(int k) const { return (2.0 + 2.0 * k) * d_; }
  std::vector<Vec2> placesAtWall(const Scene& scene) const {
    std::vector<Vec2> places;
    for (int k = 0; k < phases; ++k) places.push_back({0.5 * d_ + gap(scene, k), height(k)});
    return places;
  }
  double time(const Scene& scene) const { return 2.0 * wall_.duration() + 4.0 * longestTaken(scene); }

  FramePtr run(Scene scene, const std::vector<Vec2>& places,
               const std::function<void(Particles&, std::size_t)>& push) const {
    scene.particles.count = static_cast<std::int64_t>(places.size());
    Particles start = makeParticles(scene, places);
    for (std::size_t i = 0; i < places.size(); ++i) push(start, i);
    Simulation simulation = Simulation::make(scene, std::move(start));
    // Trouble leaves the frame as it is: far from where it should be.
    static_cast<void>(simulation.advance(ticksIn(scene, time(scene))));
    return simulation.frame();
  }

  void headOn(const Scene& scene, bool atWall) {
    std::vector<Vec2> places;
    if (atWall) {
      places = placesAtWall(scene);
    } else {
      for (int k = 0; k < phases; ++k) {
        places.push_back({2.0 * d_, height(k)});
        places.push_back({3.0 * d_ + gap(scene, k), height(k)});
      }
    }
    const FramePtr after = run(scene, places, [&](Particles& p, std::size_t i) {
      p.velocity[i].x = atWall ? -speed_ : (i % 2 == 0 ? 0.5 : -0.5) * speed_;
    });
    const DampedContact& exact = atWall ? wall_ : pair_;
    for (int k = 0; k < phases; ++k) {
      double parting = after->velocity[k].x, apart = after->position[k].x - 0.5 * d_;
      if (!atWall) {
        parting = after->velocity[2 * k + 1].x - after->velocity[2 * k].x;
        apart = after->position[2 * k + 1].x - after->position[2 * k].x - d_;
      }
      rebound_.add(parting / speed_ - exact.restitution());
      const double touch = gap(scene, k) / speed_, part = after->time - apart / parting;
      duration_.add((part - touch) / exact.duration() - 1.0);
    }
  }

  // One pair, from a fourth of the way into its contact on; error of its speed, relative to the closing one.
  double within() const {
    const double from = 0.25 * pair_.duration();
    Scene scene = scene_;
    scene.particles.count = 2;
    Particles start = makeParticles(scene, {{2.0 * d_, d_}, {3.0 * d_ - speed_ * pair_.overlap(from), d_}});
    start.velocity = {{0.5 * speed_ * pair_.rate(from), 0.0}, {-0.5 * speed_ * pair_.rate(from), 0.0}};
    Simulation simulation = Simulation::make(scene, std::move(start));
    static_cast<void>(simulation.advance(ticksIn(scene, interior * contactTimeScale(scene))));
    const FramePtr after = simulation.frame();
    const double closing = static_cast<double>(after->velocity[0].x) - after->velocity[1].x;
    return std::abs(closing / speed_ - pair_.rate(from + after->time));
  }

  Scene scene_;
  double d_, speed_;
  DampedContact pair_, wall_;
  RootMeanSquare rebound_, duration_;
};

}  // namespace

void measureContacts(const Scene& scene, Sample& into) {
  Collisions collisions(scene);
  collisions.measure(into);
  if (scene.contacts.friction) collisions.measureSliding(*scene.contacts.friction, into);
}

}  // namespace bedmix
