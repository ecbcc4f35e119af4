// SPDX-License-Identifier: MIT
#pragma once

#include "app/console.h"
#include "app/recorded_runs.h"

#include <filesystem>
#include <vector>

namespace bedmix {

/// Makes all figures that apply to the runs (at least one) as files in `folder`, which is there, and last
/// report.html with all of them inside. What two runs can share (sheet, curves over time) they do; the rest
/// is made for each, its files called by the run. Files of these names are replaced, all others left alone.
Result<Done> writeReport(std::vector<RecordedRun>& runs, const std::filesystem::path& folder,
                         const Console& console);

}  // namespace bedmix
