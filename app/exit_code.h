// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"

namespace bedmix {

/// What the program's exit status says.
enum class ExitCode {
  done = 0,
  badInput = 2,         // usage or an invalid scene
  invalidSolution = 3,  // non-finite, or beyond the overlap limit; everything up to there is on disk
  fileTrouble = 4,      // a file or the disk
  unavailable = 5,      // rendering or encoding
  stopped = 130,        // by SIGINT or SIGTERM, after a clean flush and a checkpoint
};

inline ExitCode exitCodeOf(Trouble trouble) {
  switch (trouble) {
    case Trouble::file:
      return ExitCode::fileTrouble;
    case Trouble::unavailable:
      return ExitCode::unavailable;
    case Trouble::solution:
      return ExitCode::invalidSolution;
    case Trouble::input:
      break;
  }
  return ExitCode::badInput;
}

}  // namespace bedmix
