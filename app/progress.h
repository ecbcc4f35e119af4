// SPDX-License-Identifier: MIT
#pragma once

#include "app/console.h"
#include "engine/core/frame.h"

#include <chrono>
#include <string>

namespace bedmix {

/// Says how far frames have come from the first one to `end`: simulated time, speed (simulated s per wall s),
/// time left. One line that is rewritten on a terminal, else a line every tenth of the run.
class Progress final : public FrameSink {
 public:
  Progress(const Console& console, double end);  // s, simulated
  ~Progress() override;

  void accept(const Frame& frame) override;

 private:
  using Clock = std::chrono::steady_clock;

  const Console& console_;
  double end_;
  Clock::time_point start_, shown_;
  double firstTime_ = -1.0;
  double nextLine_ = 0.0;  // simulated s at which the next plain line is due
  bool lineOpen_ = false;
};

/// "0:42", "12:05", "3:07:00".
std::string clockText(double seconds);

}  // namespace bedmix
