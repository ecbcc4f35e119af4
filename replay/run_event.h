// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace bedmix {

/// Something that happened to a run beside what its scene says, for its log.
struct RunEvent {
  double time = 0.0;   // s, simulated
  std::string kind;    // one word, at most 32 bytes: "resume", "retry", ...
  std::string detail;  // one sentence, at most 480 bytes; what is longer is cut

  bool operator==(const RunEvent&) const = default;
};

}  // namespace bedmix
