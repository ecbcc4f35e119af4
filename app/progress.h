// SPDX-License-Identifier: MIT
#pragma once

#include "app/console.h"
#include "engine/core/frame.h"

#include <chrono>
#include <cstdint>
#include <string>

namespace bedmix {

/// How far something has come, on stderr: a line with a bar that is rewritten on a terminal, else a line
/// every tenth of the way. Says nothing where the console is quiet.
class ProgressLine {
 public:
  explicit ProgressLine(const Console& console) : console_(console) {}
  ~ProgressLine();

  /// `part` from 0 to 1. Shows it where that is due, always at the end.
  void show(double part, const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;

  const Console& console_;
  Clock::time_point shown_;
  double nextLine_ = 0.0;  // part at which the next plain line is due
  bool lineOpen_ = false;
};

/// Says how far frames have come from the first one to `end`: simulated time, speed (simulated s per wall s),
/// time left.
class Progress final : public FrameSink {
 public:
  Progress(const Console& console, double end) : line_(console), end_(end) {}  // s, simulated

  void accept(const Frame& frame) override;

 private:
  using Clock = std::chrono::steady_clock;

  ProgressLine line_;
  double end_;
  Clock::time_point start_;
  double firstTime_ = -1.0;
};

/// Says how many of `total` pictures are made, how many a second, and the time left.
class PictureProgress {
 public:
  PictureProgress(const Console& console, std::int64_t total) : line_(console), total_(total) {}

  /// `kept` of the pictures made were there before, and say nothing of the pace.
  void show(std::int64_t made, std::int64_t kept = 0);

 private:
  using Clock = std::chrono::steady_clock;

  ProgressLine line_;
  std::int64_t total_;
  std::int64_t shown_ = -1;
  Clock::time_point start_ = Clock::now();
};

/// "0:42", "12:05", "3:07:00".
std::string clockText(double seconds);

}  // namespace bedmix
