// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace CLI {
class App;
}

namespace bedmix {

/// Which frames of a run a command takes.
struct FrameSelection {
  double from = 0.0;                                    // s
  double to = std::numeric_limits<double>::infinity();  // s
  int every = 1;                                        // of those between
  friend bool operator==(const FrameSelection&, const FrameSelection&) = default;
};
/// `last` is the option that names the last second.
void addFrameSelection(CLI::App& command, FrameSelection& selection, const char* last = "--to");

/// Indices of the selected ones of frames at `times`; at least one, or the reason why there is none.
Result<std::vector<std::size_t>> selectFrames(const std::vector<double>& times,
                                              const FrameSelection& selection);

}  // namespace bedmix
