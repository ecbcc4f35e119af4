// SPDX-License-Identifier: MIT
#include "engine/core/scene_tree.h"

#include "engine/core/presets.h"
#include "engine/core/scene_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace bedmix {

namespace {

/// A scene's own keys have three parts. The parser goes as deep as tables do, and its stack ends some 30,000
/// tables down; values in values it counts itself, up to 256.
constexpr int mostParts = 64;

/// Where in `text` a dotted key has more parts; its size where none has. What looks like one in a text or a
/// remark is taken for one.
std::size_t tooDeep(std::string_view text) {
  constexpr std::string_view quotesAndSpaces = "\"'-_ \t";
  int parts = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '.' && i > 0 && text[i - 1] != '.')
      ++parts;
    else if (!std::isalnum(static_cast<unsigned char>(c)) && quotesAndSpaces.find(c) == quotesAndSpaces.npos)
      parts = 1;
    if (parts > mostParts) return i;
  }
  return text.size();
}

std::string tooManyParts() { return fmt::format("a key of more than {} parts; a scene has none", mostParts); }

std::vector<std::string_view> segments(std::string_view path) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t dot = path.find('.');
    parts.push_back(path.substr(0, dot));
    if (dot == std::string_view::npos) return parts;
    path.remove_prefix(dot + 1);
  }
}

/// Element `name` of a table, or element number `name` of a list; null where there is none.
toml::node* child(toml::node& parent, std::string_view name) {
  if (auto* table = parent.as_table()) return table->get(name);
  if (auto* list = parent.as_array()) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
    if (error == std::errc{} && end == name.data() + name.size()) return list->get(index);
  }
  return nullptr;
}

void assign(toml::node& parent, std::string_view name, const toml::node& value) {
  if (auto* table = parent.as_table()) {
    table->insert_or_assign(name, value);
  } else if (auto* list = parent.as_array()) {
    const auto index = std::find_if(list->begin(), list->end(),
                                    [&](const toml::node& n) { return &n == child(*list, name); });
    list->replace(index, value);
  }
}

}  // namespace

SourceLocation placeOf(const Override& override) {
  return {override.origin.empty() ? "--set " + override.path : override.origin};
}

void Problems::add(const std::string& path, const toml::source_region& at, std::string message) {
  spoiled_.insert(path);
  list_.push_back({locate(path, at), std::move(message)});
}

void Problems::add(const Override& override, std::string message) {
  spoiled_.insert(override.path);
  list_.push_back({placeOf(override), std::move(message)});
}

void Problems::derive(std::string path, std::string source, const toml::source_region& at) {
  derived_.insert_or_assign(std::move(path), Origin{std::move(source), at});
}

void Problems::spoil(std::string path) { spoiled_.insert(std::move(path)); }

bool Problems::isSpoiled(std::string_view path) const {
  return std::any_of(spoiled_.begin(), spoiled_.end(), [&](const std::string& bad) {
    return isAtOrBelow(path, bad) || isAtOrBelow(bad, path);
  });
}

std::vector<Diagnostic> Problems::inFileOrder() {
  std::stable_sort(list_.begin(), list_.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.at.line, a.at.column) < std::pair(b.at.line, b.at.column);
  });
  return std::move(list_);
}

SourceLocation Problems::locate(std::string_view path, const toml::source_region& at) const {
  if (const auto from = derived_.find(path); from != derived_.end())
    return locate(from->second.path, from->second.at);
  for (const Override& o : overrides_)
    if (isAtOrBelow(path, o.path)) return placeOf(o);
  const std::string_view table = path.substr(0, path.rfind('.'));
  for (const Override& o : overrides_)  // of a table that only an override has opened
    if (!at.begin && isAtOrBelow(o.path, table)) return placeOf(o);
  return {file_, static_cast<int>(at.begin.line), static_cast<int>(at.begin.column)};
}

Result<toml::table> parseToml(std::string_view text, const std::string& file) {
  if (const std::size_t at = tooDeep(text); at < text.size()) {
    const std::size_t lineStart = text.substr(0, at).rfind('\n') + 1;  // 0 on the first line
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    return Diagnostic{{file, static_cast<int>(line), static_cast<int>(at - lineStart + 1)}, tooManyParts()};
  }
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    return Diagnostic{{file, static_cast<int>(at.line), static_cast<int>(at.column)},
                      fmt::format("this is not TOML: {}", error.description())};
  }
}

void applyOverride(toml::table& root, const Override& override, Problems& problems) {
  if (tooDeep(override.path) < override.path.size()) return problems.add(override, tooManyParts());
  const std::vector<std::string_view> parts = segments(override.path);
  if (std::any_of(parts.begin(), parts.end(), [](std::string_view p) { return p.empty(); }))
    return problems.add(override, "a path is made of keys with dots between them, e.g. gas.step=5e-5");

  toml::node* parent = &root;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    toml::node* next = child(*parent, parts[i]);
    if (!next && parent->is_table()) {
      if (override.value.empty()) return;
      next = &parent->as_table()->insert(parts[i], toml::table{}).first->second;
    }
    if (!next || !(next->is_table() || next->is_array()))
      return problems.add(override,
                          fmt::format("there is no table or list element \"{}\" on this path", parts[i]));
    parent = next;
  }

  const std::string_view name = parts.back();
  if (parent->is_array() && !child(*parent, name))
    return problems.add(override, fmt::format("the list has {} elements, counted from 0; there is no \"{}\"",
                                              parent->as_array()->size(), name));
  if (override.value.empty()) {
    if (parent->is_table())
      parent->as_table()->erase(name);
    else
      problems.add(override, "an element of a list cannot be removed; give the whole list");
    return;
  }
  const auto parsed = parseToml("value = " + override.value, "");
  if (parsed && parsed->size() == 1)
    assign(*parent, name, *parsed->get("value"));
  else if (std::isalpha(static_cast<unsigned char>(override.value.front())))
    assign(*parent, name, toml::value<std::string>(override.value));
  else
    problems.add(override,
                 fmt::format("\"{}\" is not a TOML value; write e.g. 1.5, true, \"text\" or [[8, 0.012]]",
                             override.value));
}

void applyPreset(toml::table& root, Problems& problems) {
  const toml::node* const chosen = root.get("accuracy");
  const auto* const name = chosen ? chosen->as_string() : nullptr;
  const auto accuracy = name ? findModel<Accuracy>(name->get()) : std::nullopt;
  if (!accuracy) return;  // what is there instead is refused as it is read
  for (const PresetKey& key : presetOf(*accuracy)) {
    const std::size_t dot = key.path.find('.');
    const toml::table* const table = root[key.path.substr(0, dot)].as_table();
    if (!table || table->contains(key.path.substr(dot + 1))) continue;
    applyOverride(root, {std::string(key.path), std::string(key.value)}, problems);
    problems.derive(std::string(key.path), "accuracy", chosen->source());
  }
}

toml::source_region sourceOf(const toml::table& root, std::string_view path) {
  const toml::node* node = &root;
  for (const std::string_view part : segments(path)) {
    const toml::node* next = child(const_cast<toml::node&>(*node), part);
    if (!next) break;
    node = next;
  }
  return node->source();
}

}  // namespace bedmix
