// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene_description.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bedmix {

/// What a key of a scene is at present, for those who show scenes or change them.
struct SceneValue {
  std::string path;                       // dotted, elements of lists by number: "gas.inlets.0.velocity"
  Key key;                                // name, unit, range, meaning
  std::string text;                       // as TOML
  std::optional<double> number;           // where it is one
  std::vector<std::string_view> choices;  // where it is a name: all there are
};

/// Every key that has a value, in the order of the file; see sceneSettings().
std::vector<SceneValue> sceneValues(const Scene& scene);

}  // namespace bedmix
