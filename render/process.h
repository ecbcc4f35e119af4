// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

#include <string>
#include <vector>

namespace bedmix {

struct ProcessEnd {
  int status = 0;      // 0: well; else its exit code, or 128 and the signal that ended it
  std::string output;  // what it printed, errors included
};

/// Runs a program found on the PATH with `input` as its standard input and waits for its end. Fails where it
/// cannot be started.
Result<ProcessEnd> runProcess(const std::vector<std::string>& command, const std::string& input);

}  // namespace bedmix
