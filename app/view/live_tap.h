// SPDX-License-Identifier: MIT
#pragma once

#include "app/view/live_recorder.h"
#include "app/view/view_series.h"
#include "engine/live_run.h"

#include <chrono>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace bedmix {

/// What is made of every frame of a live run: the curves of the panel and, while it is on, a recording. Where
/// the tracer is chosen anew or the run restarted, which one file cannot tell, the recording goes on in
/// another folder. Told of frames in the solver's thread; all else may be called from another.
class LiveTap final : public FrameTap {
 public:
  LiveTap(const Scene& scene, std::filesystem::path folder);

  void accept(const FramePtr& frame) override;
  void note(const Steering& steering) override;

  /// Records into the next free folder of its own, from the last frame on; its name, or why it cannot.
  Result<std::string> record(bool film);
  /// Ends the recording; what went wrong with it.
  std::optional<Diagnostic> stop();
  /// Name of the recording's folder; empty while there is none.
  std::string recording() const;
  /// Why the last recording has ended by itself.
  std::optional<Diagnostic> failure() const;

  std::vector<PanelChart> charts() const;
  /// "simulated 3 s in 4.1 s", of all frames so far.
  std::string farewell() const;

 private:
  // With the recorder's lock.
  Result<std::string> begin();
  std::optional<Diagnostic> end();
  void fail(std::optional<Diagnostic> trouble);

  mutable std::mutex mutex_;  // of all but the recorder, whose disk may be slow
  std::mutex recorderMutex_;  // taken first, where both are
  std::filesystem::path folder_, recording_;
  std::shared_ptr<const Scene> scene_;  // of the last frame
  ViewSeries series_;
  FramePtr last_;
  std::unique_ptr<LiveRecorder> recorder_;
  std::optional<Diagnostic> failure_;
  double simulated_ = 0.0, lastTime_ = 0.0;  // s
  std::optional<std::chrono::steady_clock::time_point> begun_, seen_;
  bool films_ = false;
};

}  // namespace bedmix
