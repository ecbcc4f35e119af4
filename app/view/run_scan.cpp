// SPDX-License-Identifier: MIT
#include "app/view/run_scan.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace bedmix {

namespace {

using Clock = std::chrono::steady_clock;
/// Often enough to see it grow.
constexpr std::chrono::milliseconds newsInterval{100};

void addPlace(const Frame& frame, std::int32_t id, std::vector<Vec2f>& path) {
  const auto found = std::lower_bound(frame.id.begin(), frame.id.end(), id);
  if (found != frame.id.end() && *found == id)
    path.push_back(frame.position[static_cast<std::size_t>(found - frame.id.begin())]);
}

}  // namespace

struct RunScan::State {
  std::string run;
  RecordingOptions options;

  mutable std::mutex mutex;
  std::condition_variable_any changed;
  std::optional<Wish> wish;
  bool isScanning = false, hasEnded = false;
  std::shared_ptr<const Found> found = std::make_shared<const Found>();
  std::jthread thread;  // last: joins before the rest goes

  void publish(const ViewSeries& series, std::vector<Vec2f> path, double done) {
    auto news = std::make_shared<const Found>(Found{series.charts(), std::move(path), done});
    const std::lock_guard lock(mutex);
    if (!wish) found = std::move(news);  // else it is about something else already
  }

  bool isWanted(const std::stop_token& stop) const {
    const std::lock_guard lock(mutex);
    return !wish && !stop.stop_requested();
  }

  /// A frame that cannot be read is a gap: who looks at it is told why.
  void scan(RecordedFrames& reader, const Wish& asked, const std::stop_token& stop) {
    ViewSeries series(reader.scene());
    series.resample(asked.grid);
    std::vector<Vec2f> path;
    const std::size_t frames = reader.times().size();
    Clock::time_point told = Clock::now();
    for (std::size_t i = 0; i < frames && isWanted(stop); ++i) {
      const auto frame = reader.frame(i);
      if (!frame) continue;
      series.observe(asked.tags ? asked.tags->applied(**frame) : **frame);
      if (asked.particle) addPlace(**frame, *asked.particle, path);
      if (Clock::now() - told < newsInterval && i + 1 < frames) continue;
      told = Clock::now();
      publish(series, path, static_cast<double>(i + 1) / static_cast<double>(frames));
    }
  }

  void work(const std::stop_token& stop) {
    auto opened = openRuns(std::span(&run, 1), options);
    std::unique_lock lock(mutex);
    while (opened && changed.wait(lock, stop, [&] { return wish.has_value(); })) {
      const Wish asked = *std::exchange(wish, std::nullopt);
      isScanning = true;
      lock.unlock();
      scan(*opened->front().reader, asked, stop);
      lock.lock();
      isScanning = false;
      changed.notify_all();
    }
    hasEnded = true;
    changed.notify_all();
  }
};

RunScan::RunScan(std::string run, RecordingOptions options) : state_(std::make_unique<State>()) {
  state_->run = std::move(run);
  state_->options = std::move(options);
  state_->thread = std::jthread([s = state_.get()](const std::stop_token& stop) { s->work(stop); });
}
RunScan::~RunScan() = default;

void RunScan::ask(const Wish& wish) {
  const std::lock_guard lock(state_->mutex);
  state_->wish = wish;
  state_->changed.notify_all();
}

void RunScan::finish() {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [s = state_.get()] { return s->hasEnded || (!s->wish && !s->isScanning); });
}

std::shared_ptr<const RunScan::Found> RunScan::found() const {
  const std::lock_guard lock(state_->mutex);
  return state_->found;
}

}  // namespace bedmix
