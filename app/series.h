// SPDX-License-Identifier: MIT
#pragma once

#include "app/run_folder.h"
#include "engine/core/scene.h"
#include "replay/file_sink.h"

#include <memory>
#include <vector>

namespace bedmix {

/// Makes the series the scene calls for in the folder: mixing.csv, with a flux window flux.csv, with gas
/// pressure.csv.
Result<std::vector<std::unique_ptr<FileSink>>> openSeries(const RunFolder& folder, const Scene& scene);

}  // namespace bedmix
