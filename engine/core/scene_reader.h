// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/contradiction.h"
#include "engine/core/diagnostic.h"
#include "engine/core/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace bedmix {

/// A `--set path=value` of the command line: a dotted key and TOML text, e.g. {"gas.step", "5e-5"}. Elements
/// of lists go by number ("gas.inlets.0.velocity_umf"), a bare word is a text, and an empty value removes the
/// key, or the whole table with the effect it switches on.
struct Override {
  std::string path;
  std::string value;
  std::string origin = {};  // what messages call it; "--set path" where empty
};
/// What messages about an override call its place.
SourceLocation placeOf(const Override& override);

/// Reads a scene from TOML text. Strict: syntax, unknown keys (with the key that was probably meant), wrong
/// types, values out of range, contradictions between keys; all of them at once, each with file:line:column.
/// `file` is the name messages use; overrides are applied before anything is checked and are located as
/// "--set path" (or their origin).
Result<Scene> readScene(std::string_view toml, const std::string& file,
                        const std::vector<Override>& overrides = {});

/// The scene as TOML with every default written out. readScene(writeScene(s)) == s, bit for bit.
std::string writeScene(const Scene& scene);

/// A key that a scene has, dotted, elements of lists by number, and its value as TOML.
struct SceneSetting {
  std::string path, value;

  bool operator==(const SceneSetting&) const = default;
};
/// What writeScene() writes, in its order.
std::vector<SceneSetting> sceneSettings(const Scene& scene);

}  // namespace bedmix
