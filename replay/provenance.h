// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace bedmix {

/// The program a file comes from.
struct Provenance {
  std::string version;
  std::string commit;

  bool operator==(const Provenance&) const = default;
};

}  // namespace bedmix
