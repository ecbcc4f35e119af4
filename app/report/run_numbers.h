// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace bedmix {

/// One of the numbers a run is summed up by.
struct RunNumber {
  std::string name;   // "mean Ashton index A, second half"
  std::string value;  // with its unit; "-" where it is undefined
};

/// From the series in a run's folder: when the bed was mixed, indices and counted fraction, flux, pressure
/// drop over the bed's weight, bed height. Means of what settles are over the second half of the run. Without
/// a series its numbers are missing.
Result<std::vector<RunNumber>> runNumbers(const std::filesystem::path& folder, const Scene& scene);

}  // namespace bedmix
