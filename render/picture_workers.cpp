// SPDX-License-Identifier: MIT
#include "render/picture_workers.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace bedmix {

namespace {

struct Task {
  std::int64_t number = 0;
  Image* picture = nullptr;
  PictureWorkers::Work work;
  std::int64_t times = 0;
};

}  // namespace

struct PictureWorkers::State {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<Image> images;
  std::vector<Image*> free;
  Image* drawn = nullptr;  // what next() gave
  std::deque<Task> waiting;
  std::int64_t submitted = 0;
  bool closed = false, dropped = false;
  std::int64_t failedAt = 0;
  std::vector<Diagnostic> problems;  // of the picture failedAt
  std::vector<std::thread> threads;

  explicit State(int count);
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State();

  void run();
  void carryOut(const Task& task);
  /// Waits until the threads have ended.
  void close(bool drop);
  bool inVain() {
    const std::lock_guard lock(mutex);
    return dropped || !problems.empty();
  }
};

PictureWorkers::State::State(int count) : images(static_cast<std::size_t>(count) + 2) {
  for (Image& image : images) free.push_back(&image);
  for (int i = 0; i < count; ++i) threads.emplace_back([this] { run(); });
}

PictureWorkers::State::~State() { close(true); }

void PictureWorkers::State::run() {
  for (;;) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return !waiting.empty() || closed; });
    if (waiting.empty()) return;
    const Task task = std::move(waiting.front());
    waiting.pop_front();
    lock.unlock();
    carryOut(task);
    lock.lock();
    free.push_back(task.picture);
    changed.notify_all();
  }
}

void PictureWorkers::State::carryOut(const Task& task) {
  for (std::int64_t i = 0; i < task.times && !inVain(); ++i) {
    const Result<Done> done = task.work(*task.picture);
    if (done) continue;
    const std::lock_guard lock(mutex);
    if (problems.empty() || task.number < failedAt) {
      problems = done.problems;
      failedAt = task.number;
    }
  }
}

void PictureWorkers::State::close(bool drop) {
  {
    const std::lock_guard lock(mutex);
    closed = true;
    dropped = drop;
  }
  changed.notify_all();
  for (std::thread& thread : threads) thread.join();
  threads.clear();
}

PictureWorkers::PictureWorkers(int threads) : state_(std::make_unique<State>(threads)) {}
PictureWorkers::~PictureWorkers() = default;
PictureWorkers::PictureWorkers(PictureWorkers&&) noexcept = default;
PictureWorkers& PictureWorkers::operator=(PictureWorkers&&) noexcept = default;

Image& PictureWorkers::next() {
  State& s = *state_;
  if (!s.drawn) {
    std::unique_lock lock(s.mutex);
    s.changed.wait(lock, [&] { return !s.free.empty(); });
    s.drawn = s.free.back();
    s.free.pop_back();
  }
  return *s.drawn;
}

void PictureWorkers::submit(Work work, std::int64_t times) {
  State& s = *state_;
  {
    const std::lock_guard lock(s.mutex);
    s.waiting.push_back({s.submitted++, std::exchange(s.drawn, nullptr), std::move(work), times});
  }
  s.changed.notify_all();
}

bool PictureWorkers::failed() const {
  const std::lock_guard lock(state_->mutex);
  return !state_->problems.empty();
}

Result<Done> PictureWorkers::finish() {
  State& s = *state_;
  s.close(false);
  if (!s.problems.empty()) return s.problems;
  return Done{};
}

}  // namespace bedmix
