// SPDX-License-Identifier: MIT
#pragma once

#include "app/attempts.h"
#include "replay/summary.h"

namespace bedmix {

/// What summary.json says of a run.
RunSummary summarize(const RunPlan& plan, const RunOutcome& outcome);

/// What a user should know of a run that ended well enough.
void reportSteps(const Console& console, const Scene& scene, const StepReport& report);

}  // namespace bedmix
