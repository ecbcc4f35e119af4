// SPDX-License-Identifier: MIT
#include "engine/worker.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>

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

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

struct Worker::State {
  Scene scene;
  int threads;

  std::mutex mutex;
  std::condition_variable_any changed;
  std::deque<FramePtr> channel;
  bool closed = false;
  RunEnd end;
  std::jthread thread;  // last: joins before the rest goes

  State(const Scene& s, int t) : scene(s), threads(t) {
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

  /// Waits for room; false if the run is to stop.
  bool send(FramePtr frame, const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    if (!changed.wait(lock, stop, [&] { return channel.size() < channelCapacity(*frame); })) return false;
    channel.push_back(std::move(frame));
    changed.notify_all();
    return true;
  }

  RunEnd run(const std::stop_token& stop) {
    RunEnd outcome;
    Result<Simulation> made = Simulation::make(scene, threads);
    if (!made) {
      outcome.reason = EndReason::invalid;
      outcome.message = toString(made.problems.front());
      return outcome;
    }
    Simulation& simulation = *made;

    const auto running = std::chrono::steady_clock::now();
    const std::int64_t last = totalSteps(scene), perFrame = stepsPerFrame(scene);
    bool sent = send(simulation.frame(), stop);
    while (sent && simulation.step() < last) {
      if (auto trouble = simulation.advance(std::min(perFrame, last - simulation.step()))) {
        outcome.reason = EndReason::invalid;
        outcome.message = *trouble;
        break;
      }
      sent = send(simulation.frame(), stop);
      if (stop.stop_requested()) break;
    }
    if (outcome.reason != EndReason::invalid && simulation.step() < last) outcome.reason = EndReason::stopped;
    outcome.wallSeconds = secondsSince(running);
    outcome.simulatedSeconds = simulation.time();
    outcome.steps = simulation.step();
    outcome.gasSteps = simulation.gasSteps();
    outcome.stages = simulation.stageSeconds();
    outcome.report = simulation.report();
    outcome.stateHash = simulation.stateHash();
    return outcome;
  }
};

Worker::Worker(const Scene& scene, int threads) : state_(std::make_unique<State>(scene, threads)) {}
Worker::~Worker() = default;

FramePtr Worker::next() {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [&] { return !state_->channel.empty() || state_->closed; });
  if (state_->channel.empty()) return nullptr;
  FramePtr frame = std::move(state_->channel.front());
  state_->channel.pop_front();
  state_->changed.notify_all();
  return frame;
}

void Worker::requestStop() { state_->thread.request_stop(); }

const RunEnd& Worker::end() const { return state_->end; }

}  // namespace bedmix
