// SPDX-License-Identifier: MIT
#include "app/progress.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace bedmix {

namespace {

constexpr int barWidth = 28;
constexpr std::chrono::milliseconds refresh{100};

}  // namespace

std::string clockText(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  const auto h = whole / 3600, m = whole / 60 % 60, s = whole % 60;
  return h > 0 ? fmt::format("{}:{:02}:{:02}", h, m, s) : fmt::format("{}:{:02}", m, s);
}

ProgressLine::~ProgressLine() {
  if (lineOpen_) std::fputc('\n', stderr);
}

void ProgressLine::show(double part, const std::string& text) {
  if (console_.quiet) return;
  const auto now = Clock::now();
  const bool atEnd = part >= 1.0 - 1e-9;
  if (!atEnd && (console_.isTerminal() ? now - shown_ < refresh : part < nextLine_)) return;
  shown_ = now;
  nextLine_ = part + 0.1;
  if (!console_.isTerminal()) return console_.say(text);
  const auto filled = static_cast<int>(std::min(1.0, part) * barWidth);
  const std::string line =
      fmt::format("\r\033[K[{:#<{}}{:.<{}}] {}", "", filled, "", barWidth - filled, text);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  lineOpen_ = true;
}

void Progress::accept(const Frame& frame) {
  const auto now = Clock::now();
  if (firstTime_ < 0.0) {
    firstTime_ = frame.time;
    start_ = now;
  }
  const double wall = std::chrono::duration<double>(now - start_).count();
  const double speed = wall > 0.0 ? (frame.time - firstTime_) / wall : 0.0;
  const double span = end_ - firstTime_;
  const double part = span > 0.0 ? (frame.time - firstTime_) / span : 1.0;
  std::string text = fmt::format("{:8.3f} s of {:g} s", frame.time, end_);
  if (speed > 0.0)
    text += fmt::format(", {:.3g} simulated s/s, {} left", speed, clockText((end_ - frame.time) / speed));
  line_.show(part, text);
}

void PictureProgress::show(std::int64_t made, std::int64_t kept) {
  if (made == shown_) return;
  shown_ = made;
  const double wall = std::chrono::duration<double>(Clock::now() - start_).count();
  const double pace = wall > 0.0 ? static_cast<double>(made - kept) / wall : 0.0;
  std::string text = fmt::format("{} of {} pictures", made, total_);
  if (pace > 0.0)
    text += fmt::format(", {:.3g} pictures/s, {} left", pace,
                        clockText(static_cast<double>(total_ - made) / pace));
  line_.show(static_cast<double>(made) / static_cast<double>(total_), text);
}

}  // namespace bedmix
