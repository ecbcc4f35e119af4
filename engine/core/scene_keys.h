// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/scene_description.h"

#include <string>
#include <string_view>
#include <vector>

namespace bedmix {

/// One key a scene may hold, for messages, help and documentation.
struct SceneKey {
  std::string path;          // dotted: "gas.inlets.from"
  Key key;                   // name, unit, range, meaning
  std::string type;          // "number", "whole number", "text", "table", ... or the names to choose from
  std::string defaultValue;  // as TOML; empty where there is none
  bool mayBeAbsent = false;  // from a scene with all defaults written out: of an effect, or without a default
};

/// Every key of every table, in the order of the file.
std::vector<SceneKey> sceneKeys();

/// The path of a key without the numbers of elements: "gas.inlets.from" of "gas.inlets.0.from".
std::string withoutNumbers(std::string_view path);

/// Whether a path is that of a table or of something in it.
bool isAtOrBelow(std::string_view path, std::string_view table);

/// "above 0 m", "from 0 to 1", "" without limits.
std::string rangeText(const Key& key);

/// A number as TOML writes it, shortest round trip.
std::string tomlNumber(double value);

/// Names of layers as a TOML list, in the order they are drawn.
std::string tomlNames(Layers layers);

/// A text as a TOML basic string, quoted and escaped.
std::string tomlString(const std::string& text);

}  // namespace bedmix
