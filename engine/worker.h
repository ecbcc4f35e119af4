// SPDX-License-Identifier: MIT
#pragma once

#include "engine/checkpoint.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "engine/simulation.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bedmix {

enum class EndReason { finished, stopped, invalid };

/// How a run ended, and what it took.
struct RunEnd {
  EndReason reason = EndReason::finished;
  std::string message;             // why, where the reason is `invalid`
  std::optional<Refinement> cure;  // what may help then, where anything may
  double simulatedSeconds = 0.0;
  double wallSeconds = 0.0;  // from t = 0 on, those before the run was resumed included
  std::int64_t steps = 0;    // of the particles
  std::int64_t gasSteps = 0;
  StageSeconds stages{};
  StepReport report;
  std::optional<double> lastCheckpoint;  // of this worker; simulated s
  std::uint64_t stateHash = 0;
};

/// When checkpoints are due, whichever comes first: at the first frame, after so many seconds, and at the
/// last.
struct CheckpointSchedule {
  double wallSeconds = 60.0;
  double simulatedSeconds = 1.0;
};
using Checkpoint = std::shared_ptr<const std::vector<std::byte>>;  // see engine/checkpoint.h

/// The solver in a thread of its own. Hands out a frame at t = 0 and one every sampling interval through a
/// bounded channel: recording loses nothing, the solver waits where the reader is slower. Frames come from
/// next() on one thread; null after the last. Errors travel in end().
class Worker final : public FrameSource {
 public:
  /// Without a schedule there are no checkpoints.
  explicit Worker(const Scene& scene, int threads = 1, std::optional<CheckpointSchedule> schedule = {});
  /// Goes on with a run of the scene; its first frame is the one after those that there are already.
  Worker(const Scene& scene, Resumed start, std::optional<CheckpointSchedule> schedule);
  ~Worker() override;  // stops and joins

  FramePtr next() override;
  /// The run as it stood at the frame that next() has just returned, where that was due; else null.
  Checkpoint checkpoint();
  /// From any thread: the frame in hand comes with a checkpoint.
  void requestCheckpoint();
  /// From any thread: the run ends after the frame in hand, which comes with a checkpoint. Idempotent.
  void requestStop();
  /// Valid once next() has returned null.
  const RunEnd& end() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
