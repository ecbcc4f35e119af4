// SPDX-License-Identifier: MIT
#include "engine/worker.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>

namespace bedmix {

namespace {

/// Frames on their way to a reader that is slower than the solver: some, so that neither waits for the
/// other's every pause, but of a large bed no more than this memory holds.
constexpr std::size_t mostFrames = 16, leastFrames = 2;
constexpr std::size_t channelBytes = std::size_t{64} << 20;

std::size_t channelCapacity(const Frame& frame) {
  const std::size_t particle =
      2 * sizeof(Vec2f) + sizeof(float) + sizeof(std::uint8_t) + sizeof(std::int32_t);
  return std::clamp(channelBytes / (particle * frame.size() + 1), leastFrames, mostFrames);
}

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Message {
  FramePtr frame;
  Checkpoint checkpoint;
};

}  // namespace

struct Worker::State {
  Scene scene;
  int threads = 1;
  std::optional<CheckpointSchedule> schedule;
  std::optional<Resumed> resumed;

  std::mutex mutex;
  std::condition_variable_any changed;
  std::deque<Message> channel;
  Checkpoint taken;  // with the frame that was taken last
  std::atomic<bool> checkpointAsked{false};
  bool closed = false;
  RunEnd end;
  std::jthread thread;  // last: joins before the rest goes

  void begin() {
    thread = std::jthread([this](const std::stop_token& stop) {
      RunEnd outcome;
      try {
        outcome = run(stop);
      } catch (const std::exception& e) {  // out of memory, mostly: it must not end the program from here
        outcome.reason = EndReason::invalid;
        outcome.message = e.what();
      }
      const std::lock_guard lock(mutex);
      end = std::move(outcome);
      closed = true;
      changed.notify_all();
    });
  }

  /// Whether no checkpoint is waiting for the reader, as happens where that is slow.
  bool isCheckpointRead() {
    const std::lock_guard lock(mutex);
    return std::none_of(channel.begin(), channel.end(), [](const Message& m) { return m.checkpoint; });
  }

  /// Waits for room; false if the run is to stop, with this as its last frame.
  bool send(Message message, const std::stop_token& stop, const std::function<Checkpoint()>& save) {
    std::unique_lock lock(mutex);
    changed.wait(lock, stop, [&] { return channel.size() < channelCapacity(*message.frame); });
    const bool stops = stop.stop_requested();
    if (stops && !message.checkpoint) message.checkpoint = save();
    channel.push_back(std::move(message));
    changed.notify_all();
    return !stops;
  }

  RunEnd run(const std::stop_token& stop) {
    RunEnd outcome;
    const bool isNew = !resumed;
    if (isNew) {
      Result<Simulation> made = Simulation::make(scene, threads);
      if (!made) {
        outcome.reason = EndReason::invalid;
        outcome.message = toString(made.problems.front());
        if (made.problems.front().trouble == Trouble::solution) outcome.cure = Refinement{1, 0};
        return outcome;
      }
      resumed = Resumed{std::move(*made), 0.0};
    }
    Simulation& simulation = resumed->simulation;

    const Clock::time_point running = Clock::now();
    const std::int64_t last = totalSteps(scene), perFrame = stepsPerFrame(scene);
    const auto wallSeconds = [&] { return resumed->wallSeconds + secondsSince(running); };

    Clock::time_point savedAt = running;
    double savedTime = simulation.time();
    const auto save = [&]() -> Checkpoint {
      if (!schedule) return nullptr;
      savedAt = Clock::now();
      outcome.lastCheckpoint = savedTime = simulation.time();
      return std::make_shared<const std::vector<std::byte>>(
          writeCheckpoint(simulation, scene, wallSeconds()));
    };
    const auto isDue = [&] {
      if (!schedule) return false;
      if (simulation.step() == 0 || simulation.step() == last || checkpointAsked.exchange(false)) return true;
      return (simulation.time() - savedTime >= schedule->simulatedSeconds ||
              secondsSince(savedAt) >= schedule->wallSeconds) &&
             isCheckpointRead();
    };
    const auto sendFrame = [&] { return send({simulation.frame(), isDue() ? save() : nullptr}, stop, save); };

    bool goesOn = !isNew || sendFrame();
    while (goesOn && simulation.step() < last) {
      // Frames fall on whole multiples of their interval, wherever the run was resumed.
      const std::int64_t step = simulation.step(), chunk = perFrame - step % perFrame;
      if (auto trouble = simulation.advance(std::min(chunk, last - step))) {
        outcome.reason = EndReason::invalid;
        outcome.message = *trouble;
        outcome.cure = Refinement{1, simulation.gasFailed() ? 1 : 0};
        break;
      }
      goesOn = sendFrame();
    }
    if (outcome.reason != EndReason::invalid && simulation.step() < last) outcome.reason = EndReason::stopped;
    outcome.wallSeconds = wallSeconds();
    outcome.simulatedSeconds = simulation.time();
    outcome.steps = simulation.particleSteps();
    outcome.gasSteps = simulation.gasSteps();
    outcome.stages = simulation.stageSeconds();
    outcome.report = simulation.report();
    outcome.stateHash = simulation.stateHash();
    return outcome;
  }
};

Worker::Worker(const Scene& scene, int threads, std::optional<CheckpointSchedule> schedule)
    : state_(std::make_unique<State>()) {
  state_->scene = scene;
  state_->threads = threads;
  state_->schedule = schedule;
  state_->begin();
}

Worker::Worker(const Scene& scene, Resumed start, std::optional<CheckpointSchedule> schedule)
    : state_(std::make_unique<State>()) {
  state_->scene = scene;
  state_->schedule = schedule;
  state_->resumed = std::move(start);
  state_->begin();
}

Worker::~Worker() = default;

FramePtr Worker::next() {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [&] { return !state_->channel.empty() || state_->closed; });
  if (state_->channel.empty()) return nullptr;
  Message message = std::move(state_->channel.front());
  state_->channel.pop_front();
  state_->taken = std::move(message.checkpoint);
  state_->changed.notify_all();
  return std::move(message.frame);
}

Checkpoint Worker::checkpoint() {
  const std::lock_guard lock(state_->mutex);
  return std::move(state_->taken);
}

void Worker::requestCheckpoint() { state_->checkpointAsked = true; }

void Worker::requestStop() { state_->thread.request_stop(); }

const RunEnd& Worker::end() const { return state_->end; }

}  // namespace bedmix
