// SPDX-License-Identifier: MIT
#pragma once

#include "app/accuracy/sample_log.h"
#include "app/progress.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bedmix {

/// One sample to be taken.
struct Task {
  SampleKey key;
  double cost = 1.0;                     // what it is thought to take, beside others of its kind
  std::function<bool(Sample&)> measure;  // false where it was stopped
};

/// Takes samples and hands each to the log as soon as it is there.
class TaskRunner {
 public:
  /// Once `mayBegin` says no, nothing more is begun.
  TaskRunner(SampleLog& log, const Console& console, std::function<bool()> mayBegin)
      : log_(log), console_(console), mayBegin_(std::move(mayBegin)) {}

  /// Begins tasks in their order, as many at a time as there are `workers`; returns when all are through.
  void run(const std::string& name, const std::vector<Task>& tasks, int workers);

  /// Of all runs so far: tasks that were not brought to their end, and why the log cannot be written.
  int left() const { return left_; }
  const std::optional<Diagnostic>& failure() const { return failure_; }

 private:
  SampleLog& log_;
  const Console& console_;
  std::function<bool()> mayBegin_;
  int left_ = 0;
  std::optional<Diagnostic> failure_;
};

}  // namespace bedmix
