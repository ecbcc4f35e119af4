// SPDX-License-Identifier: MIT
#include "engine/core/scene_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

namespace bedmix {

namespace {

/// Visits default settings and notes each key below `prefix`.
class KeyCollector {
 public:
  explicit KeyCollector(std::vector<SceneKey>& into, std::string prefix = "", bool mayBeAbsent = false)
      : into_(into), prefix_(std::move(prefix)), mayBeAbsent_(mayBeAbsent) {}

  void operator()(const Key& key, double& v) { add(key, "number", key.required ? "" : tomlNumber(v)); }
  void operator()(const Key& key, std::int64_t& v) { add(key, "whole number", wholeDefault(key, v)); }
  void operator()(const Key& key, std::uint64_t& v) { add(key, "whole number", wholeDefault(key, v)); }
  void operator()(const Key& key, std::string& v) { add(key, "text", tomlString(v)); }
  void operator()(const Key& key, StepLength& v) {
    add(key, fmt::format("number or \"{}\"", automaticStep), tomlNumber(v));
  }
  void operator()(const Key& key, std::vector<GridSpan>&) { add(key, "list of [count, size]", ""); }

  void operator()(const Key& key, std::vector<std::int64_t>&) { add(key, "list of whole numbers", "[]"); }
  void operator()(const Key& key, Layers& v) { add(key, "list of " + names<Layer>(), tomlNames(v)); }
  void operator()(const Key& key, Rgba& v) {
    add(key, "\"white\", \"black\" or \"#rrggbb\"", tomlString(colorText(v)));
  }

  template <class T>
  void operator()(const Key& key, std::vector<T>&) {
    T element;
    const bool outside = std::exchange(mayBeAbsent_, mayBeAbsent_ || !key.required);
    descend(key, "list of tables", element);
    mayBeAbsent_ = outside;
  }

  template <class T>
  void operator()(const Key& key, std::optional<T>&) {
    T value{};
    const bool outside = std::exchange(mayBeAbsent_, true);
    if constexpr (std::is_same_v<T, double>)
      add(key, "number", "");
    else if constexpr (std::is_enum_v<T>)
      add(key, names<T>(), "");
    else
      descend(key, "table", value);
    mayBeAbsent_ = outside;
  }

  template <class T>
  void operator()(const Key& key, T& value) {
    if constexpr (std::is_enum_v<T>)
      add(key, names<T>(), fmt::format("\"{}\"", modelName(value)));
    else
      descend(key, "table", value);
  }

 private:
  template <class T>
  static std::string names() {
    std::string list;
    for (const ModelInfo& m : modelTable<T>)
      list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", m.name);
    return list;
  }

  template <class T>
  static std::string wholeDefault(const Key& key, T value) {
    return key.required ? "" : fmt::format("{}", value);
  }

  void add(const Key& key, std::string type, std::string defaultValue) {
    into_.push_back(
        {prefix_ + std::string(key.name), key, std::move(type), std::move(defaultValue), mayBeAbsent_});
  }

  template <class T>
  void descend(const Key& key, std::string type, T& value) {
    add(key, std::move(type), "");
    KeyCollector inner(into_, prefix_ + std::string(key.name) + '.', mayBeAbsent_);
    describe(value, inner);
  }

  std::vector<SceneKey>& into_;
  std::string prefix_;
  bool mayBeAbsent_;
};

}  // namespace

std::vector<SceneKey> sceneKeys() {
  std::vector<SceneKey> keys;
  Scene defaults;
  KeyCollector collect(keys);
  describe(defaults, collect);
  return keys;
}

std::string withoutNumbers(std::string_view path) {
  std::string key;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string_view part = path.substr(begin, end - begin);
    const bool isNumber = !part.empty() && std::all_of(part.begin(), part.end(),
                                                       [](unsigned char c) { return std::isdigit(c) != 0; });
    if (!isNumber) key.append(key.empty() ? "" : ".").append(part);
    begin = end + 1;
  }
  return key;
}

bool isAtOrBelow(std::string_view path, std::string_view table) {
  return path.starts_with(table) && (path.size() == table.size() || path[table.size()] == '.');
}

std::string rangeText(const Key& key) {
  const KeyRange& r = key.range;
  const std::string unit = key.unit.empty() ? "" : fmt::format(" {}", key.unit);
  const bool below = std::isfinite(r.min), above = std::isfinite(r.max);
  if (below && above)
    return fmt::format("{} {} {} {}{}", r.aboveMin ? "above" : "from", r.min,
                       r.aboveMin ? "and at most" : "to", r.max, unit);
  if (below) return fmt::format("{} {}{}", r.aboveMin ? "above" : "at least", r.min, unit);
  if (above) return fmt::format("at most {}{}", r.max, unit);
  return "";
}

std::string tomlNumber(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string tomlNames(Layers layers) {
  std::string list;
  for (const std::string_view name : layerNames(layers))
    list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
  return '[' + list + ']';
}

std::string tomlString(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      quoted += fmt::format("\\{}", c);
    else if (code < 0x20 || code == 0x7f)
      quoted += fmt::format("\\u{:04X}", code);
    else
      quoted += c;
  }
  return quoted + '"';
}

}  // namespace bedmix
