// SPDX-License-Identifier: MIT
#include "engine/core/scene_reader.h"

#include "engine/core/near_miss.h"
#include "engine/core/scene_description.h"
#include "engine/core/scene_keys.h"
#include "engine/core/scene_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <type_traits>

namespace bedmix {

namespace {

// Far more than any scene asks for, and little enough to list all that is wrong with it in no time.
constexpr std::size_t longestText = 65536;  // bytes
constexpr std::size_t longestList = 1000;   // elements

std::string join(const std::string& path, std::string_view name) {
  return path.empty() ? std::string(name) : fmt::format("{}.{}", path, name);
}

std::string bracketed(const std::string& path) { return path.empty() ? "the scene" : '[' + path + ']'; }

/// What a value of the wrong type is, in words.
std::string describeValue(const toml::node& node) {
  if (const auto* text = node.as_string()) return fmt::format("the text \"{}\"", text->get());
  if (const auto* number = node.as_floating_point()) return fmt::format("the number {}", number->get());
  if (const auto* whole = node.as_integer()) return fmt::format("the number {}", whole->get());
  if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
  if (node.is_table()) return "a table";
  if (node.is_array()) return "a list";
  return "a date or time";
}

/// Reads one table into one settings struct: called by its description once a key.
class TableReader {
 public:
  TableReader(const toml::table& table, std::string path, Problems& problems)
      : table_(table), path_(std::move(path)), problems_(problems) {}

  template <class T>
  void operator()(const Key& key, T& value) {
    known_.emplace_back(key.name);
    const std::string path = join(path_, key.name);
    if (const toml::node* node = table_.get(key.name))
      read(key, *node, path, value);
    else if (key.required)
      problems_.add(path, table_.source(),
                    fmt::format("{} lacks {} ({})", bracketed(path_), nameOf(key, value, path), key.meaning));
  }

  /// Keys of the table that no description asked for.
  void refuseUnknownKeys() {
    for (auto&& [key, node] : table_) {
      const std::string name(key.str());
      if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
      if (const auto meant = nearMiss(name, known_)) problems_.spoil(join(path_, *meant));
      problems_.add(join(path_, name), key.source(),
                    fmt::format("unknown key \"{}\" in {}{}", name, bracketed(path_), whatWasMeant(name)));
    }
  }

 private:
  template <class T>
  static std::string nameOf(const Key& key, const T&, const std::string& path) {
    constexpr bool isTable = requires(T & table, TableReader & reader) { describe(table, reader); };
    return isTable ? fmt::format("the table [{}]", path) : fmt::format("the key \"{}\"", key.name);
  }
  static std::string nameOf(const Key& key, const std::vector<GridSpan>&, const std::string&) {
    return fmt::format("the key \"{}\"", key.name);
  }
  static std::string nameOf(const Key& key, const std::vector<std::int64_t>&, const std::string&) {
    return fmt::format("the key \"{}\"", key.name);
  }
  template <class T>
  static std::string nameOf(const Key&, const std::vector<T>&, const std::string& path) {
    return fmt::format("tables [[{}]]", path);
  }

  /// A near miss here first, then a key of this name elsewhere in the scene.
  std::string whatWasMeant(const std::string& name) const {
    if (std::string meant = didYouMean(name, known_); !meant.empty()) return meant;
    for (const SceneKey& key : sceneKeys()) {
      if (key.key.name != name) continue;
      if (key.type == "table") return fmt::format("; did you mean [{}]?", key.path);
      const auto dot = key.path.rfind('.');
      return dot == std::string::npos ? "; it belongs at the top of the file, before the first table"
                                      : fmt::format("; it belongs in [{}]", key.path.substr(0, dot));
    }
    std::string names;
    for (const std::string& known : known_) names += (names.empty() ? "" : ", ") + known;
    return "; known here: " + names;
  }

  void wrongType(const toml::node& node, const std::string& path, std::string_view wanted,
                 std::string_view table = "") {
    problems_.add(path, node.source(),
                  fmt::format("{} must be {}, not {}{}", path, wanted, describeValue(node), table));
  }

  bool isTooLong(const toml::array& list, const std::string& path) {
    if (list.size() <= longestList) return false;
    problems_.add(path, list.source(),
                  fmt::format("{} has {} elements; at most {} are read", path, list.size(), longestList));
    return true;
  }

  void checkRange(const Key& key, const toml::node& node, const std::string& path, double value) {
    const KeyRange& r = key.range;
    const bool inside =
        std::isfinite(value) && value <= r.max && (r.aboveMin ? value > r.min : value >= r.min);
    if (inside) return;
    const std::string wanted = std::isfinite(value) ? rangeText(key) : "a finite number";
    const std::string_view space = key.unit.empty() ? "" : " ";
    problems_.add(
        path, node.source(),
        fmt::format("{} is {}{}{}; it must be {} ({})", path, value, space, key.unit, wanted, key.meaning));
  }

  void read(const Key& key, const toml::node& node, const std::string& path, double& value) {
    if (!node.is_number()) return wrongType(node, path, "a number");
    value = *node.value<double>();
    checkRange(key, node, path, value);
  }

  void read(const Key& key, const toml::node& node, const std::string& path, StepLength& value) {
    if (const auto* text = node.as_string(); text && text->get() == automaticStep) {
      value = StepLength::automatic();
      return;
    }
    if (!node.is_number()) return wrongType(node, path, fmt::format("a number or \"{}\"", automaticStep));
    double seconds = 0.0;
    read(key, node, path, seconds);
    value = seconds;
  }

  template <class T>
  requires(std::is_same_v<T, std::int64_t> ||
           std::is_same_v<T, std::uint64_t>) void read(const Key& key, const toml::node& node,
                                                       const std::string& path, T& value) {
    const auto* whole = node.as_integer();
    if (!whole) return wrongType(node, path, "a whole number");
    value = static_cast<T>(whole->get());
    checkRange(key, node, path, static_cast<double>(whole->get()));
  }

  void read(const Key&, const toml::node& node, const std::string& path, std::string& value) {
    const auto* text = node.as_string();
    if (!text) return wrongType(node, path, "a text");
    value = text->get();
  }

  template <class T>
  requires std::is_enum_v<T>
  void read(const Key&, const toml::node& node, const std::string& path, T& value) {
    const auto* text = node.as_string();
    if (!text) return wrongType(node, path, "a name in quotes", "\n  it is one of" + table<T>());
    if (const auto model = findModel<T>(text->get())) {
      value = *model;
      return;
    }
    std::vector<std::string> names;
    for (const ModelInfo& m : modelTable<T>) names.emplace_back(m.name);
    problems_.add(path, node.source(),
                  fmt::format("{} has no \"{}\"{}\n  it is one of{}", path, text->get(),
                              didYouMean(text->get(), names), table<T>()));
  }

  template <class T>
  static std::string table() {
    std::string text;
    for (const ModelInfo& m : modelTable<T>) {
      text += fmt::format("\n    {:<22}{}", m.name, m.formula);
      if (!m.citation.empty()) text += fmt::format(" [{}]", m.citation);
    }
    return text;
  }

  template <class T>
  void read(const Key& key, const toml::node& node, const std::string& path, std::optional<T>& value) {
    read(key, node, path, value.emplace());
  }

  void read(const Key&, const toml::node& node, const std::string& path, std::vector<GridSpan>& spans) {
    constexpr std::string_view wanted = "a list of [count, size] pairs, e.g. [[8, 0.012]]";
    const auto* list = node.as_array();
    if (!list || list->empty()) return wrongType(node, path, wanted);
    if (isTooLong(*list, path)) return;
    std::size_t index = 0;
    for (const toml::node& element : *list) {
      const auto* pair = element.as_array();
      if (!pair || pair->size() != 2) return wrongType(element, path, wanted);
      const std::string at = join(path, std::to_string(index++));
      GridSpan& span = spans.emplace_back();
      read(Key{"count", "", {1.0, 1e5}, "cells of the stretch"}, *pair->get(0), at, span.count);
      read(Key{"size", "m", positive, "size of a cell"}, *pair->get(1), at, span.size);
    }
  }

  void read(const Key& key, const toml::node& node, const std::string& path, Layers& layers) {
    const auto* list = node.as_array();
    if (!list) return wrongType(node, path, "a list of names, e.g. [\"particles\", \"walls\"]");
    if (isTooLong(*list, path)) return;
    layers = {};
    std::size_t index = 0;
    for (const toml::node& element : *list) {
      Layer layer{};
      read(key, element, join(path, std::to_string(index++)), layer);
      layers.add(layer);
    }
  }

  void read(const Key&, const toml::node& node, const std::string& path, Rgba& color) {
    constexpr std::string_view wanted = "\"white\", \"black\" or a colour like \"#1a2b3c\"";
    const auto* text = node.as_string();
    const auto parsed = text ? parseColor(text->get()) : std::nullopt;
    if (!parsed) return wrongType(node, path, wanted);
    color = *parsed;
  }

  void read(const Key& key, const toml::node& node, const std::string& path,
            std::vector<std::int64_t>& numbers) {
    const auto* list = node.as_array();
    if (!list) return wrongType(node, path, "a list of whole numbers, e.g. [0, 500]");
    if (isTooLong(*list, path)) return;
    for (const toml::node& element : *list)
      read(key, element, join(path, std::to_string(numbers.size())), numbers.emplace_back());
  }

  template <class T>
  void read(const Key&, const toml::node& node, const std::string& path, std::vector<T>& tables) {
    const auto* list = node.as_array();
    if (!list) return wrongType(node, path, fmt::format("tables, each headed [[{}]]", path));
    if (isTooLong(*list, path)) return;
    for (const toml::node& element : *list) {
      const std::string at = join(path, std::to_string(tables.size()));
      readTable(element, at, tables.emplace_back());
    }
  }

  template <class T>
  void read(const Key&, const toml::node& node, const std::string& path, T& settings) {
    readTable(node, path, settings);
  }

  template <class T>
  void readTable(const toml::node& node, const std::string& path, T& settings) {
    const auto* inner = node.as_table();
    if (!inner) return wrongType(node, path, "a table");
    TableReader reader(*inner, path, problems_);
    describe(settings, reader);
    reader.refuseUnknownKeys();
  }

  const toml::table& table_;
  std::string path_;
  Problems& problems_;
  std::vector<std::string> known_;
};

}  // namespace

Result<Scene> readScene(std::string_view toml, const std::string& file,
                        const std::vector<Override>& overrides) {
  if (toml.size() > longestText)
    return Diagnostic{{file},
                      fmt::format("this is {} bytes long; a scene has at most {}", toml.size(), longestText)};
  Result<toml::table> root = parseToml(toml, file);
  if (!root) return std::move(root.problems);

  Problems problems(file, overrides);
  for (const Override& override : overrides) applyOverride(*root, override, problems);
  applyPreset(*root, problems);

  Scene scene;
  scene.name = std::filesystem::path(file).stem().string();
  TableReader reader(*root, "", problems);
  describe(scene, reader);
  reader.refuseUnknownKeys();
  std::vector<Contradiction> broken = contradictions(scene);
  std::erase_if(broken, [&](const Contradiction& c) {  // what follows from a value already refused
    const auto refused = [&](const std::string& path) { return problems.isSpoiled(path); };
    return refused(c.path) || std::any_of(c.concerns.begin(), c.concerns.end(), refused);
  });
  for (Contradiction& c : broken) problems.add(c.path, sourceOf(*root, c.path), std::move(c.message));
  if (!problems.empty()) return problems.inFileOrder();
  return scene;
}

}  // namespace bedmix
