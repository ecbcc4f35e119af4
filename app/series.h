// SPDX-License-Identifier: MIT
#pragma once

#include "app/run_folder.h"
#include "engine/core/scene.h"
#include "replay/file_sink.h"

#include <memory>
#include <string>
#include <vector>

namespace bedmix {

using Series = std::vector<std::unique_ptr<FileSink>>;

/// Makes the series the scene calls for in the folder: mixing.csv, with a flux window flux.csv, with gas
/// pressure.csv, with heat heat.csv, with a reaction
/// reaction.csv, with a feed feed.csv.
Result<Series> openSeries(const RunFolder& folder, const Scene& scene);
/// Their names, without ".csv".
std::vector<std::string> seriesNames(const Scene& scene);

}  // namespace bedmix
