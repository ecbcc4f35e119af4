// SPDX-License-Identifier: MIT
#include "engine/core/scene_values.h"

#include "engine/core/scene_keys.h"
#include "engine/core/scene_reader.h"

#include <algorithm>
#include <charconv>

namespace bedmix {

namespace {

std::optional<double> numberOf(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  return std::from_chars(text.data(), end, value).ptr == end ? std::optional(value) : std::nullopt;
}

/// The names that a type consists of: "\"open\", \"lid\"".
std::vector<std::string_view> choicesOf(std::string_view type) {
  std::vector<std::string_view> names;
  while (type.starts_with('"')) {
    const std::size_t end = type.find('"', 1);
    names.push_back(type.substr(1, end - 1));
    type.remove_prefix(end + 1);
    if (!type.starts_with(", ")) break;
    type.remove_prefix(2);
  }
  return type.empty() ? names : std::vector<std::string_view>();
}

}  // namespace

std::vector<SceneValue> sceneValues(const Scene& scene) {
  static const std::vector<SceneKey> keys = sceneKeys();
  std::vector<SceneValue> values;
  for (SceneSetting& setting : sceneSettings(scene)) {
    const auto key =
        std::find_if(keys.begin(), keys.end(),
                     [plain = withoutNumbers(setting.path)](const SceneKey& k) { return k.path == plain; });
    const auto number = numberOf(setting.value);
    values.push_back(
        {std::move(setting.path), key->key, std::move(setting.value), number, choicesOf(key->type)});
  }
  return values;
}

}  // namespace bedmix
