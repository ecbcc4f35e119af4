// SPDX-License-Identifier: MIT
#include "app/view/live_recorder.h"

#include "app/recording.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>

namespace bedmix {

namespace {

constexpr std::size_t mostWaiting = 16;  // frames and events

}  // namespace

struct LiveRecorder::State {
  using Item = std::variant<FramePtr, RunEvent>;

  Recording recording;
  mutable std::mutex mutex;
  std::condition_variable changed;
  std::deque<Item> waiting;
  bool ends = false;
  std::optional<Diagnostic> failure;
  std::jthread thread;  // last: joins before the rest goes

  explicit State(Recording made) : recording(std::move(made)) {}

  void put(Item item) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return waiting.size() < mostWaiting || failure; });
    if (failure || ends) return;
    waiting.push_back(std::move(item));
    changed.notify_all();
  }

  /// All HDF5 of the recording is done in this thread.
  void run() {
    for (;;) {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return !waiting.empty() || ends; });
      if (waiting.empty()) break;
      const Item item = std::move(waiting.front());
      waiting.pop_front();
      changed.notify_all();
      lock.unlock();
      if (const auto* frame = std::get_if<FramePtr>(&item))
        recording.accept(**frame);
      else
        recording.note(std::get<RunEvent>(item));
      if (const auto trouble = recording.failure()) {
        lock.lock();
        failure = trouble;
        changed.notify_all();
        return;
      }
    }
    recording.finish();
    const std::lock_guard lock(mutex);
    failure = recording.failure();
    if (!failure && !recording.filmProblems().empty()) failure = recording.filmProblems().front();
  }

  void end() {
    {
      const std::lock_guard lock(mutex);
      ends = true;
      changed.notify_all();
    }
    if (thread.joinable()) thread.join();
  }
};

LiveRecorder::LiveRecorder(std::unique_ptr<State> state) : state_(std::move(state)) {
  state_->thread = std::jthread([s = state_.get()] { s->run(); });
}
LiveRecorder::~LiveRecorder() { state_->end(); }

Result<std::unique_ptr<LiveRecorder>> LiveRecorder::create(const std::filesystem::path& folder,
                                                           const Scene& scene, bool film) {
  const auto made = makeRunFolder(folder, false);
  if (!made) return made.problems;
  std::optional<FilmOptions> options;
  if (film) options.emplace().paint = {{}, styleOf(scene), 1, {}};
  auto recording = Recording::create(*made, scene, options);
  if (!recording) return recording.problems;
  return std::unique_ptr<LiveRecorder>(new LiveRecorder(std::make_unique<State>(std::move(*recording))));
}

void LiveRecorder::accept(const FramePtr& frame) { state_->put(frame); }
void LiveRecorder::note(const RunEvent& event) { state_->put(event); }

std::optional<Diagnostic> LiveRecorder::failure() const {
  const std::lock_guard lock(state_->mutex);
  return state_->failure;
}

std::optional<Diagnostic> LiveRecorder::finish() {
  state_->end();
  return failure();
}

}  // namespace bedmix
