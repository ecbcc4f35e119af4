// SPDX-License-Identifier: MIT
#include "engine/core/scene_values.h"

#include "engine/core/scene_keys.h"

#include <fmt/format.h>

#include <type_traits>

namespace bedmix {

namespace {

class ValueCollector {
 public:
  explicit ValueCollector(std::vector<SceneValue>& into, std::string prefix = "")
      : into_(into), prefix_(std::move(prefix)) {}

  void operator()(const Key& key, double& v) { add(key, tomlNumber(v), v); }
  void operator()(const Key& key, std::int64_t& v) { add(key, fmt::format("{}", v), static_cast<double>(v)); }
  void operator()(const Key& key, std::uint64_t& v) {
    add(key, fmt::format("{}", v), static_cast<double>(v));
  }
  void operator()(const Key& key, std::string& v) { add(key, tomlString(v)); }
  void operator()(const Key& key, StepLength& v) {
    if (v.isAutomatic())
      add(key, tomlString(automaticStep));
    else
      add(key, tomlNumber(v), static_cast<double>(v));
  }
  void operator()(const Key& key, Layers& v) { add(key, tomlNames(v)); }
  void operator()(const Key& key, Rgba& v) { add(key, tomlString(colorText(v))); }
  void operator()(const Key& key, std::vector<std::int64_t>& v) {
    add(key, fmt::format("[{}]", fmt::join(v, ", ")));
  }
  void operator()(const Key& key, std::vector<GridSpan>& spans) {
    std::string list;
    for (const GridSpan& s : spans)
      list += fmt::format("{}[{}, {}]", list.empty() ? "" : ", ", s.count, tomlNumber(s.size));
    add(key, '[' + list + ']');
  }
  void operator()(const Key& key, std::vector<Inlet>& inlets) {
    for (std::size_t i = 0; i < inlets.size(); ++i) descend(fmt::format("{}.{}", key.name, i), inlets[i]);
  }
  void operator()(const Key& key, std::optional<double>& v) {
    if (v)
      add(key, tomlNumber(*v), *v);
    else
      add(key, "");
  }

  template <class T>
  void operator()(const Key& key, std::optional<T>& value) {
    if (value)
      (*this)(key, *value);
    else if constexpr (std::is_enum_v<T>)
      add(key, "", {}, names<T>());
  }

  template <class T>
  void operator()(const Key& key, T& value) {
    if constexpr (std::is_enum_v<T>)
      add(key, fmt::format("\"{}\"", modelName(value)), {}, names<T>());
    else
      descend(std::string(key.name), value);
  }

 private:
  template <class T>
  static std::vector<std::string_view> names() {
    std::vector<std::string_view> all;
    for (const ModelInfo& model : modelTable<T>) all.push_back(model.name);
    return all;
  }

  void add(const Key& key, std::string text, std::optional<double> number = {},
           std::vector<std::string_view> choices = {}) {
    into_.push_back({prefix_ + std::string(key.name), key, std::move(text), number, std::move(choices)});
  }

  template <class T>
  void descend(const std::string& name, T& value) {
    ValueCollector inner(into_, prefix_ + name + '.');
    describe(value, inner);
  }

  std::vector<SceneValue>& into_;
  std::string prefix_;
};

}  // namespace

std::vector<SceneValue> sceneValues(const Scene& scene) {
  Scene copy = scene;  // a description visits settings it may change
  std::vector<SceneValue> values;
  ValueCollector collect(values);
  describe(copy, collect);
  return values;
}

}  // namespace bedmix
