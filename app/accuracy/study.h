// SPDX-License-Identifier: MIT
#pragma once

#include "app/accuracy/design.h"
#include "app/accuracy/plan.h"
#include "app/accuracy/start_states.h"
#include "app/accuracy/tasks.h"
#include "app/accuracy/trajectory.h"

#include <chrono>
#include <functional>
#include <set>

namespace bedmix {

/// Takes all samples of a design that the log has not got: first wall times, one run at a time, then the
/// rest with a run on each core.
class Study {
 public:
  struct Options {
    double budget;  // s of wall time; infinite for as much as the design takes
    int cores;
    int runs;                    // of each preset, that statistics are taken from
    std::function<bool()> stop;  // asked for from outside; looked at often
  };
  Study(const Scene& scene, const Design& design, SampleLog& log, const Console& console, Options options);

  /// Empty when it is through, stopped or out of budget; else why it cannot go on.
  std::optional<Diagnostic> run();

  /// What the budget left of the statistics; from run() on.
  const StatisticsPlan& plan() const { return plan_; }
  int samplesLeft() const { return runner_.left(); }

 private:
  double elapsed() const;  // s
  bool mayBegin() const { return !options_.stop() && elapsed() < options_.budget; }
  bool has(const SampleKey& key) const;
  std::optional<Diagnostic> makeStarts();
  void timings();
  void contacts();
  void divergences();
  double horizon() const;
  void trajectories();
  void statistics();

  const Scene& scene_;
  const Design& design_;
  SampleLog& log_;
  const Console& console_;
  Options options_;
  std::chrono::steady_clock::time_point begin_;
  StartStates starts_;
  TaskRunner runner_;
  StatisticsPlan plan_;
};

}  // namespace bedmix
