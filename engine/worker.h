// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/scene.h"
#include "engine/simulation.h"

#include <cstdint>
#include <memory>
#include <string>

namespace bedmix {

enum class EndReason { finished, stopped, invalid };

/// How a run ended, and what it took.
struct RunEnd {
  EndReason reason = EndReason::finished;
  std::string message;  // why, where the reason is `invalid`
  double simulatedSeconds = 0.0;
  double wallSeconds = 0.0;  // from t = 0 on
  std::int64_t steps = 0;
  std::int64_t gasSteps = 0;
  StageSeconds stages{};
  StepReport report;
  std::uint64_t stateHash = 0;
};

/// The solver in a thread of its own. Hands out a frame at t = 0 and one every sampling interval through a
/// bounded channel: recording loses nothing, the solver waits where the reader is slower. Frames come from
/// next() on one thread; null after the last. Errors travel in end().
class Worker final : public FrameSource {
 public:
  explicit Worker(const Scene& scene, int threads = 1);
  ~Worker() override;  // stops and joins

  FramePtr next() override;
  /// From any thread: the run ends after the frame in hand. Idempotent.
  void requestStop();
  /// Valid once next() has returned null.
  const RunEnd& end() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace bedmix
