// SPDX-License-Identifier: MIT
#pragma once

#include "app/recorded_runs.h"
#include "app/view/view_series.h"
#include "replay/tracer_choice.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bedmix {

/// Goes through all frames of a recorded run in a thread of its own, for what pictures of one frame do not
/// tell: the curves of the indices and the path of a particle. Begins anew whenever it is asked for others.
class RunScan {
 public:
  struct Wish {
    SamplingGrid grid;
    std::shared_ptr<const Retagging> tags;  // null: the tracer of the recording
    std::optional<std::int32_t> particle;   // whose path is wanted
  };
  struct Found {
    std::vector<PanelChart> charts;
    std::vector<Vec2f> path;  // m, in order of time
    double done = 0.0;        // share of the frames
  };

  /// `run` is as openRuns() takes it; the scan reads it by itself.
  RunScan(std::string run, RecordingOptions options);
  ~RunScan();

  void ask(const Wish& wish);
  /// Waits until the last wish is fulfilled.
  void finish();
  /// As far as it has come with the last wish; grows with each.
  std::shared_ptr<const Found> found() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
