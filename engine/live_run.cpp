// SPDX-License-Identifier: MIT
#include "engine/live_run.h"

#include "engine/core/steering.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace bedmix {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double longestPeriod = 3600.0;  // s, from one frame to the next, however slow it is to be
constexpr double remembered = 0.5;        // s, that the measured speed is a mean of

Clock::duration clockTime(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(Seconds(seconds));
}

}  // namespace

/// Members without a mutex are the solver's thread's own.
struct LiveRun::State {
  struct Order {
    std::function<void()> act;  // empty where there is none
    bool isTick = false;
  };

  State(const Scene& first, int count, Pace whose, std::function<void()> call)
      : scene(first), threads(count), pace(whose), onNews(std::move(call)) {
    news.scene = std::make_shared<const Scene>(scene);
    newest = std::make_shared<const Snapshot>(news);
  }

  Scene scene;
  const int threads;
  const Pace pace;
  const std::function<void()> onNews;
  std::optional<Simulation> simulation;
  Snapshot news;              // the next one
  double period = 0.0;        // s, from the beginning of one frame to that of the next, at least
  Clock::time_point due{};    // when the next one may begin
  Clock::time_point ended{};  // when the last one did, or the rest before it

  mutable std::mutex newestMutex;
  SnapshotPtr newest;

  std::mutex tapMutex;
  FrameTap* tap = nullptr;
  FramePtr tapFrame;  // the present one

  std::mutex mutex;
  std::condition_variable_any changed;
  std::deque<Order> orders;
  std::int64_t ticksAsked = 0, ticksDone = 0;
  std::jthread thread;  // last: joins before the rest goes

  void give(std::function<void()> act) {
    const std::lock_guard lock(mutex);
    orders.push_back({std::move(act)});
    changed.notify_all();
  }

  void tick() {
    std::unique_lock lock(mutex);
    const std::int64_t mine = ++ticksAsked;
    orders.push_back({[this] {
                        if (news.isPlaying) goOn();
                      },
                      true});
    changed.notify_all();
    changed.wait(lock, [&] { return ticksDone >= mine; });
  }
  void endTick() {
    const std::lock_guard lock(mutex);
    ++ticksDone;
    changed.notify_all();
  }

  /// The next order; none where the run is to stop, or there is none and a frame is due.
  Order next(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    const auto isAsked = [this] {
      return pace == Pace::free ? !orders.empty() : ticksDone < ticksAsked && !orders.empty();
    };
    if (pace == Pace::free && news.isPlaying)
      changed.wait_until(lock, stop, due, isAsked);
    else
      changed.wait(lock, stop, isAsked);
    if (stop.stop_requested() || !isAsked()) return {};
    Order order = std::move(orders.front());
    orders.pop_front();
    return order;
  }

  void run(const std::stop_token& stop) {
    const auto guarded = [this](const auto& action) {
      try {
        action();
      } catch (const std::exception& e) {  // out of memory, mostly: it must not end the program from here
        fail(e.what());
      }
    };
    guarded([this] { arrange(); });
    while (!stop.stop_requested()) {
      const Order order = next(stop);
      if (order.act)
        guarded(order.act);
      else if (!stop.stop_requested())
        guarded([this] { goOn(); });
      if (order.isTick) endTick();
    }
  }

  void publish() {
    ++news.number;
    auto snapshot = std::make_shared<const Snapshot>(news);
    {
      const std::lock_guard lock(newestMutex);
      newest = std::move(snapshot);
    }
    if (onNews) onNews();
  }

  void fail(std::string trouble) {
    news.trouble = std::move(trouble);
    rest();
  }

  void rest() {
    news.isPlaying = false;
    news.speed = 0.0;
    publish();
  }

  void arrange() {
    Result<Simulation> made = Simulation::make(scene, threads);
    if (!made) return fail(toString(made.problems.front()));
    simulation = std::move(*made);
    showFrame();
    due = ended = Clock::now();
    publish();
  }

  /// Looks at the simulation as it is now, for the next snapshot and the tap.
  void showFrame() {
    news.frame = simulation->frame();
    news.contacts = simulation->contacts();
    news.stages = simulation->stageSeconds();
    news.report = simulation->report();
    if (pace == Pace::ticked) news.stateHash = simulation->stateHash();
    const std::lock_guard lock(tapMutex);
    tapFrame = news.frame;
    if (tap) tap->accept(tapFrame);
  }

  bool canGoOn() const { return simulation && news.trouble.empty(); }

  void goOn() {
    if (!canGoOn()) return rest();
    // Behind by less than a frame it catches up.
    due = std::max(due, Clock::now() - clockTime(period)) + clockTime(period);
    if (auto trouble = simulation->advance(stepsPerFrame(scene))) return fail(std::move(*trouble));
    showFrame();
    measureSpeed();
    publish();
  }

  void measureSpeed() {
    if (pace == Pace::ticked || !news.isPlaying) return;
    const Clock::time_point now = Clock::now();
    const double passed = std::max(Seconds(now - ended).count(), 1e-9);
    const double speed = scene.sampling.interval / passed;
    news.speed += (news.speed > 0.0 ? std::min(1.0, passed / remembered) : 1.0) * (speed - news.speed);
    ended = now;
  }

  void play(bool on) {
    if (!on || !canGoOn()) return rest();
    if (!news.isPlaying) due = ended = Clock::now();
    news.isPlaying = true;
    publish();
  }

  void step() {
    news.isPlaying = false;
    news.speed = 0.0;
    goOn();
  }

  void note(std::string kind, std::string detail) {
    const std::lock_guard lock(tapMutex);
    if (tap)
      tap->note({simulation ? simulation->time() : 0.0, std::move(kind), std::move(detail), news.scene});
  }

  void restart() {
    note("restart", "");
    scene.tickKept.reset();
    simulation.reset();
    const bool plays = news.isPlaying;
    Snapshot fresh;
    fresh.number = news.number;
    fresh.scene = news.scene;
    fresh.isPlaying = plays;
    news = std::move(fresh);
    {
      const std::lock_guard lock(tapMutex);
      tapFrame.reset();
    }
    publish();
    arrange();
  }

  void limitSpeed(double most) {
    due -= clockTime(period);
    period = most > 0.0 ? std::min(scene.sampling.interval / most, longestPeriod) : longestPeriod;
    due += clockTime(period);
  }

  void change(const std::vector<Override>& changes) {
    Result<Scene> steered = steeredScene(scene, changes);
    news.refusal = steered ? "" : toString(steered.problems.front());
    if (steered) {
      if (canGoOn() && !simulation->steer(*steered))
        return fail("the run cannot go on: its state is not finite");
      scene = std::move(*steered);
      news.scene = std::make_shared<const Scene>(scene);
      for (const Override& c : changes) note("set", fmt::format("{} = {}", c.path, c.value));
    }
    publish();
  }

  void tagTracer(TracerRule rule) {
    scene.tracer.rule = rule;
    news.scene = std::make_shared<const Scene>(scene);
    note("tracer", std::string(modelName(rule)));
    if (canGoOn()) {
      simulation->setTracer(rule);
      const std::lock_guard lock(tapMutex);
      news.frame = tapFrame = simulation->frame();
    }
    publish();
  }
};

LiveRun::LiveRun(const Scene& scene, int threads, Pace pace, std::function<void()> onNews)
    : state_(std::make_unique<State>(scene, threads, pace, std::move(onNews))) {
  state_->thread = std::jthread([state = state_.get()](const std::stop_token& stop) { state->run(stop); });
}

LiveRun::~LiveRun() = default;

SnapshotPtr LiveRun::newest() const {
  const std::lock_guard lock(state_->newestMutex);
  return state_->newest;
}

void LiveRun::play(bool on) {
  state_->give([s = state_.get(), on] { s->play(on); });
}
void LiveRun::step() {
  state_->give([s = state_.get()] { s->step(); });
}
void LiveRun::restart() {
  state_->give([s = state_.get()] { s->restart(); });
}
void LiveRun::limitSpeed(double most) {
  state_->give([s = state_.get(), most] { s->limitSpeed(most); });
}
void LiveRun::change(std::vector<Override> changes) {
  state_->give([s = state_.get(), changes = std::move(changes)] { s->change(changes); });
}
void LiveRun::tagTracer(TracerRule rule) {
  state_->give([s = state_.get(), rule] { s->tagTracer(rule); });
}

void LiveRun::setTap(FrameTap* tap) {
  const std::lock_guard lock(state_->tapMutex);
  state_->tap = tap;
  if (tap && state_->tapFrame) tap->accept(state_->tapFrame);
}

void LiveRun::tick() { state_->tick(); }

}  // namespace bedmix
