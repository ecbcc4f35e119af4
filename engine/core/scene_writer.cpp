// SPDX-License-Identifier: MIT
#include "engine/core/scene_description.h"
#include "engine/core/scene_keys.h"
#include "engine/core/scene_reader.h"

#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

namespace bedmix {

namespace {

/// Writes one table: its own keys first, then the tables inside it, as TOML wants them.
class TableWriter {
 public:
  explicit TableWriter(std::string path = "") : path_(std::move(path)) {}

  void operator()(const Key& key, double& v) { line(key, tomlNumber(v)); }
  void operator()(const Key& key, std::int64_t& v) { line(key, fmt::format("{}", v)); }
  void operator()(const Key& key, std::uint64_t& v) { line(key, fmt::format("{}", v)); }
  void operator()(const Key& key, std::string& v) { line(key, tomlString(v)); }
  void operator()(const Key& key, StepLength& v) {
    line(key, v.isAutomatic() ? tomlString(automaticStep) : tomlNumber(v));
  }

  void operator()(const Key& key, Layers& v) { line(key, tomlNames(v)); }
  void operator()(const Key& key, Rgba& v) { line(key, tomlString(colorText(v))); }
  void operator()(const Key& key, std::vector<std::int64_t>& v) {
    line(key, fmt::format("[{}]", fmt::join(v, ", ")));
  }

  void operator()(const Key& key, std::vector<GridSpan>& spans) {
    std::string list;
    for (const GridSpan& s : spans)
      list += fmt::format("{}[{}, {}]", list.empty() ? "" : ", ", s.count, tomlNumber(s.size));
    line(key, '[' + list + ']');
  }

  template <class T>
  void operator()(const Key& key, std::vector<T>& tables) {
    if (tables.empty() && key.required) line(key, "[]");
    for (std::size_t i = 0; i < tables.size(); ++i) table("[[{}]]", key, tables[i], fmt::format(".{}", i));
  }

  template <class T>
  void operator()(const Key& key, std::optional<T>& value) {
    if (value) (*this)(key, *value);
  }

  template <class T>
  void operator()(const Key& key, T& value) {
    if constexpr (std::is_enum_v<T>)
      line(key, fmt::format("\"{}\"", modelName(value)));
    else
      table("[{}]", key, value);
  }

  std::string text() const { return keys_ + tables_; }
  std::vector<SceneSetting> settings() const {
    std::vector<SceneSetting> all = ownSettings_;
    all.insert(all.end(), innerSettings_.begin(), innerSettings_.end());
    return all;
  }

 private:
  void line(const Key& key, const std::string& value) {
    const std::string entry = fmt::format("{} = {}", key.name, value);
    const std::string_view comma = key.unit.empty() ? "" : ", ";
    fmt::format_to(std::back_inserter(keys_), "{:<32}  # {}{}{}\n", entry, key.unit, comma, key.meaning);
    ownSettings_.push_back({pathOf(key), value});
  }

  std::string pathOf(const Key& key) const {
    return path_.empty() ? std::string(key.name) : fmt::format("{}.{}", path_, key.name);
  }

  template <class T>
  void table(std::string_view header, const Key& key, T& value, const std::string& element = "") {
    const std::string path = pathOf(key);
    TableWriter inner(path + element);
    describe(value, inner);
    tables_ += '\n' + fmt::format(fmt::runtime(header), withoutNumbers(path)) + '\n' + inner.text();
    for (SceneSetting& setting : inner.settings()) innerSettings_.push_back(std::move(setting));
  }

  std::string path_, keys_, tables_;
  std::vector<SceneSetting> ownSettings_, innerSettings_;
};

TableWriter written(Scene scene) {  // a copy: a description visits settings it may change
  TableWriter writer;
  describe(scene, writer);
  return writer;
}

}  // namespace

std::string writeScene(const Scene& scene) { return written(scene).text(); }

std::vector<SceneSetting> sceneSettings(const Scene& scene) { return written(scene).settings(); }

}  // namespace bedmix
