// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"

#include <optional>
#include <utility>

namespace bedmix {

/// A sink that writes a file. The first thing that goes wrong (a full disk, say) is kept and the file is left
/// as it was after the last whole frame; later frames are ignored. Look at failure() after each frame or at
/// the end. Used from one thread.
class FileSink : public FrameSink {
 public:
  void accept(const Frame& frame) final {
    if (!failure_) failure_ = write(frame);
  }
  const std::optional<Diagnostic>& failure() const { return failure_; }

 protected:
  /// Does something else with the file, likewise.
  template <class Action>
  void unlessFailed(Action&& action) {
    if (!failure_) failure_ = action();
  }

 private:
  /// Writes one frame, or says why it could not.
  virtual std::optional<Diagnostic> write(const Frame& frame) = 0;

  std::optional<Diagnostic> failure_;
};

}  // namespace bedmix
