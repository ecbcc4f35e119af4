// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace bedmix {

/// Where a recorded run and the same run computed again part.
struct Mismatch {
  std::int64_t step = 0;  // of the first recorded state that is another
  double time = 0.0;      // s
  std::string what;       // e.g. "x of particle 12 is 0.0123, recorded as 0.0124"
};

/// What came of computing a recorded run again.
struct Verification {
  double from = 0.0, to = 0.0;            // s
  std::size_t frames = 0;                 // that are the same to the bit
  std::size_t states = 0;                 // stored double states whose hash is the same
  std::optional<Mismatch> mismatch = {};  // none where all are the same
  std::string program;                    // that recorded it: version and commit
};

/// Computes a recorded run again and compares, to the bit, every frame on the way with the recorded one, and
/// the hash of the double state with those of the checkpoints and of the end in summary.json. Starts at the
/// newest checkpoint not after `from`, or else at the beginning; without `from` at the oldest checkpoint.
/// Fails where there is nothing to compare.
Result<Verification> verifyRun(const std::filesystem::path& run, std::optional<double> from);

}  // namespace bedmix
