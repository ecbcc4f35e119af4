// SPDX-License-Identifier: MIT
#include "render/encoding_thread.h"

#include <array>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace bedmix {

struct EncodingThread::State {
  static constexpr std::size_t capacity = 4;

  Movie movie;
  std::mutex mutex;
  std::condition_variable changed;
  std::array<Image, capacity> waiting;  // a ring; its images keep their memory
  std::size_t first = 0, count = 0;
  bool closed = false;
  std::vector<Diagnostic> problems;
  std::thread thread;

  explicit State(Movie m) : movie(std::move(m)), thread([this] { run(); }) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { close(); }

  void run() {
    for (;;) {
      std::unique_lock lock(mutex);
      changed.wait(lock, [this] { return count > 0 || closed; });
      if (count == 0) return;
      const bool sound = problems.empty();
      lock.unlock();
      Result<Done> done = Done{};
      if (sound) done = movie.add(waiting[first]);  // ours as long as it is counted
      lock.lock();
      if (!done) problems = done.problems;
      first = (first + 1) % capacity;
      --count;
      changed.notify_all();
    }
  }
  void close() {
    {
      const std::lock_guard lock(mutex);
      closed = true;
    }
    changed.notify_all();
    if (thread.joinable()) thread.join();
  }
};

EncodingThread::EncodingThread(Movie movie) : state_(std::make_unique<State>(std::move(movie))) {}
EncodingThread::~EncodingThread() = default;
EncodingThread::EncodingThread(EncodingThread&&) noexcept = default;
EncodingThread& EncodingThread::operator=(EncodingThread&&) noexcept = default;

void EncodingThread::add(const Image& picture) {
  State& s = *state_;
  std::unique_lock lock(s.mutex);
  s.changed.wait(lock, [&] { return s.count < State::capacity; });
  Image& slot = s.waiting[(s.first + s.count) % State::capacity];
  slot.size = picture.size;
  slot.rgba.assign(picture.rgba.begin(), picture.rgba.end());
  ++s.count;
  s.changed.notify_all();
}

bool EncodingThread::failed() const {
  const std::lock_guard lock(state_->mutex);
  return !state_->problems.empty();
}

Result<Done> EncodingThread::finish() {
  State& s = *state_;
  s.close();
  if (!s.problems.empty()) return s.problems;
  return s.movie.finish();
}

}  // namespace bedmix
