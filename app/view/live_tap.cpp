// SPDX-License-Identifier: MIT
#include "app/view/live_tap.h"

#include <fmt/format.h>

#include <utility>

namespace bedmix {

namespace {

/// The first of NAME-1, NAME-2, ... that is not there.
std::filesystem::path nextFree(const std::filesystem::path& folder, std::string_view name) {
  for (int n = 1;; ++n) {
    std::filesystem::path path = folder / fmt::format("{}-{}", name, n);
    if (std::error_code error; !std::filesystem::exists(path, error)) return path;
  }
}

}  // namespace

LiveTap::LiveTap(const Scene& scene, std::filesystem::path folder)
    : folder_(std::move(folder)), scene_(std::make_shared<const Scene>(scene)), series_(scene) {}

void LiveTap::accept(const FramePtr& frame) {
  const std::lock_guard recorderLock(recorderMutex_);
  {
    const std::lock_guard lock(mutex_);
    last_ = frame;
    series_.observe(*frame);
    seen_ = std::chrono::steady_clock::now();
    if (!begun_) begun_ = seen_;
    if (frame->time > lastTime_) simulated_ += frame->time - lastTime_;
    lastTime_ = frame->time;
  }
  if (!recorder_) return;
  recorder_->accept(frame);
  if (recorder_->failure()) fail(end());
}

void LiveTap::note(const Steering& steering) {
  const std::lock_guard recorderLock(recorderMutex_);
  {
    const std::lock_guard lock(mutex_);
    scene_ = steering.scene;
    if (steering.kind == "set") series_.resample(samplingGrid(*scene_));
    if (steering.kind == "restart") series_ = ViewSeries(*scene_);
  }
  if (!recorder_) return;
  if (steering.kind == "set") return recorder_->note({steering.time, steering.kind, steering.detail});
  fail(end());
  last_ = nullptr;
  if (const auto begun = begin(); !begun) fail(begun.problems.front());
}

void LiveTap::fail(std::optional<Diagnostic> trouble) {
  const std::lock_guard lock(mutex_);
  failure_ = std::move(trouble);
}

Result<std::string> LiveTap::begin() {
  const std::filesystem::path path = nextFree(folder_, "recording");
  auto made = LiveRecorder::create(path, *scene_, films_);
  if (!made) return made.problems;
  recorder_ = std::move(*made);
  if (last_) recorder_->accept(last_);
  const std::lock_guard lock(mutex_);
  recording_ = path;
  return path.string();
}

std::optional<Diagnostic> LiveTap::end() {
  const auto trouble = recorder_->finish();
  recorder_.reset();
  const std::lock_guard lock(mutex_);
  recording_.clear();
  return trouble;
}

Result<std::string> LiveTap::record(bool film) {
  const std::lock_guard recorderLock(recorderMutex_);
  films_ = film;
  fail(std::nullopt);
  return begin();
}

std::optional<Diagnostic> LiveTap::stop() {
  const std::lock_guard recorderLock(recorderMutex_);
  return recorder_ ? end() : std::nullopt;
}

std::string LiveTap::recording() const {
  const std::lock_guard lock(mutex_);
  return recording_.string();
}

std::optional<Diagnostic> LiveTap::failure() const {
  const std::lock_guard lock(mutex_);
  return failure_;
}

std::string LiveTap::farewell() const {
  const std::lock_guard lock(mutex_);
  if (!begun_) return {};
  return fmt::format("simulated {:.4g} s in {:.4g} s", simulated_,
                     std::chrono::duration<double>(*seen_ - *begun_).count());
}

std::vector<PanelChart> LiveTap::charts() const {
  const std::lock_guard lock(mutex_);
  return series_.charts();
}

}  // namespace bedmix
