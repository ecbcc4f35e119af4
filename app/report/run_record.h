// SPDX-License-Identifier: MIT
#pragma once

#include "app/recorded_runs.h"
#include "app/report/html_page.h"

namespace bedmix {

/// Adds where a run comes from (scene, seed, program) and, as far as summary.json and the trajectory tell,
/// how it ended, what happened on the way and what its stages took.
Result<Done> addRecord(HtmlPage& page, const RecordedRun& run);

}  // namespace bedmix
