// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "replay/provenance.h"
#include "replay/run_event.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace bedmix {

/// The frames of a file, in random access. Whether bedmix wrote it (TrajectoryReader) or another program did
/// (ForeignFrames), nothing downstream can tell. Memory does not grow with the length of the run.
class RecordedFrames : public FrameSource {
 public:
  /// The scene as it was run, every default resolved.
  virtual const Scene& scene() const = 0;
  /// What began to record it; empty where that is not known.
  virtual const Provenance& provenance() const = 0;
  /// What happened to the run, in the order it did; empty where nothing did or that is not known.
  virtual const std::vector<RunEvent>& events() const = 0;
  /// Times of the frames, s, strictly increasing. As many as there are frames, at least one.
  virtual const std::vector<double>& times() const = 0;

  /// Frame `index`, below times().size(). Fails where the file is damaged there or holds what is no number.
  virtual Result<FramePtr> frame(std::size_t index) = 0;

  /// The frames in order. Null after the last, and where one cannot be read: then failure() says why.
  FramePtr next() final {
    if (failure_ || nextFrame_ == times().size()) return nullptr;
    Result<FramePtr> read = frame(nextFrame_++);
    if (read) return *read;
    failure_ = read.problems.front();
    return nullptr;
  }
  const std::optional<Diagnostic>& failure() const { return failure_; }

 protected:
  RecordedFrames() = default;
  RecordedFrames(RecordedFrames&&) noexcept = default;
  RecordedFrames& operator=(RecordedFrames&&) noexcept = default;

 private:
  std::size_t nextFrame_ = 0;
  std::optional<Diagnostic> failure_;
};

}  // namespace bedmix
