// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "replay/run_event.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace bedmix {

/// Records a live run from some frame on, as `bedmix run` does, in a thread of its own. Loses nothing: who
/// hands it frames faster than they can be written waits.
class LiveRecorder {
 public:
  /// `folder` is made anew.
  static Result<std::unique_ptr<LiveRecorder>> create(const std::filesystem::path& folder, const Scene& scene,
                                                      bool film);
  ~LiveRecorder();  // writes what it has been given

  void accept(const FramePtr& frame);
  void note(const RunEvent& event);
  /// Why it does not record any more.
  std::optional<Diagnostic> failure() const;
  /// Writes what it has been given and closes the files; what went wrong with any of them.
  std::optional<Diagnostic> finish();

 private:
  struct State;
  explicit LiveRecorder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
