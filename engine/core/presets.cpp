// SPDX-License-Identifier: MIT
#include "engine/core/presets.h"

namespace bedmix {

std::vector<Override> accuracyOverrides(const std::string& name) {
  const std::string origin = "--accuracy";
  std::vector<Override> overrides{{"accuracy", name, origin}};
  for (const PresetKey& key : presets.front()) overrides.push_back({std::string(key.path), "", origin});
  return overrides;
}

}  // namespace bedmix
