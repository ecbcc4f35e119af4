// SPDX-License-Identifier: MIT
#include "app/view/view_script.h"

#include "app/scene_library.h"
#include "engine/core/scene_tree.h"
#include "render/painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace bedmix {

namespace {

constexpr std::array<std::string_view, 6> kindNames{"click", "drag", "wheel", "key", "type", "resize"};

/// Reads tables and keeps what is wrong with them.
class ScriptReader {
 public:
  explicit ScriptReader(const std::string& file) : file_(file) {}

  std::vector<Diagnostic> problems;

  void fail(const toml::source_region& at, std::string message) {
    problems.push_back(
        {{file_, static_cast<int>(at.begin.line), static_cast<int>(at.begin.column)}, std::move(message)});
  }
  void expectKeys(const toml::table& table, std::initializer_list<std::string_view> known) {
    for (const auto& [key, node] : table)
      if (std::find(known.begin(), known.end(), key.str()) == known.end())
        fail(key.source(),
             fmt::format("there is no key \"{}\" here; there are {}", key.str(), fmt::join(known, ", ")));
  }
  double number(const toml::table& table, std::string_view key, double low, double high, double otherwise) {
    const toml::node* node = table.get(key);
    if (!node) return otherwise;
    const auto value = node->value<double>();
    if (value && node->is_number() && *value >= low && *value <= high) return *value;
    fail(node->source(), fmt::format("{} must be a number from {} to {}", key, low, high));
    return otherwise;
  }
  std::string text(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    if (const auto value = node ? node->value<std::string>() : std::nullopt) return *value;
    if (node) fail(node->source(), fmt::format("{} must be a text", key));
    return {};
  }
  /// [x, y].
  Vec2f pair(const toml::table& table, std::string_view key, float most = 65536.0f) {
    const toml::node& node = *table.get(key);
    const toml::array* both = node.as_array();
    if (both && both->size() == 2) {
      const auto x = (*both)[0].value<double>(), y = (*both)[1].value<double>();
      if (x && y && std::abs(*x) <= most && std::abs(*y) <= most)
        return {static_cast<float>(*x), static_cast<float>(*y)};
    }
    fail(node.source(), fmt::format("{} must be two numbers, [x, y]", key));
    return {};
  }
  ScriptPlace place(const toml::table& table, std::string_view key) {
    if (table.get(key)->is_string()) return text(table, key);
    return pair(table, key);
  }
  Size size(const toml::table& table, std::string_view key) {
    const Vec2f at = pair(table, key);
    const auto size = parseSize(fmt::format("{:.0f}x{:.0f}", at.x, at.y));
    if (size) return *size;
    fail(table.get(key)->source(), size.problems.front().message);
    return {};
  }
  ScriptStep step(const toml::table& table);

 private:
  const std::string& file_;
};

ScriptStep ScriptReader::step(const toml::table& table) {
  ScriptStep step;
  step.line = static_cast<int>(table.source().begin.line);
  step.at = number(table, "at", 0.0, 1e6, 0.0);
  const auto named = std::count_if(kindNames.begin(), kindNames.end(),
                                   [&](std::string_view name) { return table.contains(name); });
  if (named != 1) {
    fail(table.source(), fmt::format("a step must have exactly one of {}", fmt::join(kindNames, ", ")));
    return step;
  }
  for (std::size_t i = 0; i < kindNames.size(); ++i)
    if (table.contains(kindNames[i])) step.kind = static_cast<ScriptStep::Kind>(i);
  switch (step.kind) {
    case ScriptStep::Kind::click:
      expectKeys(table, {"at", "click", "touch"});
      step.place = place(table, "click");
      break;
    case ScriptStep::Kind::drag:
      expectKeys(table, {"at", "drag", "to", "touch"});
      step.place = place(table, "drag");
      if (const toml::node* to = table.get("to"); !to)
        fail(table.source(), "drag needs to, a place or a share of the item's width");
      else if (to->is_number())
        step.share = static_cast<float>(number(table, "to", 0.0, 1.0, 0.0));
      else
        step.target = place(table, "to");
      break;
    case ScriptStep::Kind::wheel:
      expectKeys(table, {"at", "wheel", "over"});
      step.turn = pair(table, "wheel");
      if (table.contains("over"))
        step.place = place(table, "over");
      else
        fail(table.source(), "wheel needs over, where the pointer is");
      break;
    case ScriptStep::Kind::key: {
      expectKeys(table, {"at", "key"});
      const std::string name = text(table, "key");
      const auto known = std::find(panelKeyNames.begin(), panelKeyNames.end(), name);
      if (known == panelKeyNames.end())
        fail(table.get("key")->source(),
             fmt::format("there is no key \"{}\"; there are {}", name, fmt::join(panelKeyNames, ", ")));
      else
        step.key = static_cast<PanelKey>(known - panelKeyNames.begin());
      break;
    }
    case ScriptStep::Kind::type:
      expectKeys(table, {"at", "type"});
      step.text = text(table, "type");
      break;
    case ScriptStep::Kind::resize:
      expectKeys(table, {"at", "resize", "scale"});
      step.size = size(table, "resize");
      step.scale = static_cast<float>(number(table, "scale", 0.5, 4.0, 1.0));
  }
  if (const toml::node* touch = table.get("touch")) step.isTouch = touch->value<bool>().value_or(false);
  return step;
}

}  // namespace

Result<ViewScript> readViewScript(const std::string& path) {
  const auto text = readTextFile(path);
  if (!text) return text.problems;
  const auto root = parseToml(*text, path);
  if (!root) return root.problems;
  ScriptReader reader(path);
  ViewScript script;
  script.file = path;
  reader.expectKeys(*root, {"size", "scale", "fps", "until", "do"});
  if (root->contains("size")) script.size = reader.size(*root, "size");
  script.scale = static_cast<float>(reader.number(*root, "scale", 0.5, 4.0, 1.0));
  script.fps = reader.number(*root, "fps", 1.0, 1000.0, script.fps);
  if (!root->contains("until"))
    reader.fail(root->source(), "until is missing: how long the script goes on, s");
  script.until = reader.number(*root, "until", 0.0, 1e6, 0.0);
  if (const toml::node* steps = root->get("do")) {
    const toml::array* list = steps->as_array();
    if (!list) reader.fail(steps->source(), "do must be a list of tables, [[do]]");
    for (std::size_t i = 0; list && i < list->size(); ++i) {
      if (const toml::table* step = (*list)[i].as_table())
        script.steps.push_back(reader.step(*step));
      else
        reader.fail((*list)[i].source(), "do must be a list of tables, [[do]]");
    }
  }
  if (!reader.problems.empty()) return reader.problems;
  return script;
}

}  // namespace bedmix
