// SPDX-License-Identifier: MIT
#pragma once

#include "app/console.h"
#include "app/recording.h"
#include "app/resume.h"
#include "app/run_folder.h"
#include "engine/core/refinement.h"
#include "engine/worker.h"
#include "replay/summary.h"

#include <optional>
#include <vector>

namespace bedmix {

/// A run that is to be computed and recorded.
struct RunPlan {
  Scene scene;  // as it was asked for
  RunFolder folder;
  int threads = 1;
  CheckpointSchedule schedule;
  std::optional<FilmOptions> film;
  bool retries = false;  // with shorter steps where the solution becomes invalid
};

/// How it came out.
struct RunOutcome {
  RunEnd end;
  Scene scene;  // as it ended, refined where there were retries
  std::vector<Retry> retries;
  std::optional<Diagnostic> failure;     // of a file other than the film
  std::vector<Diagnostic> filmProblems;  // why there is none
};

/// "time.step = 5e-06, gas.step = 5e-05": what an attempt went on with.
std::string settingsText(const RefinedSettings& settings);

/// Computes and records a run from its start, or from where an earlier one ended. Where the solution becomes
/// invalid and the plan says so, it goes back to the last checkpoint, or, without one, to the start, halves
/// the step (that of the gas, too, where that failed) and tries again, up to mostHalvings times; each retry
/// is told on the console and noted in the trajectory. Fails where the files cannot be opened.
Result<RunOutcome> carryOut(const RunPlan& plan, std::optional<ResumePoint> from, const Console& console);

}  // namespace bedmix
