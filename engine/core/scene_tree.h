// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/scene_reader.h"

#include <toml++/toml.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// The scene reader's own: TOML text with overrides applied, and the list of what is wrong with it. This
// header, its source and scene_reader.cpp are the only users of toml++.

namespace bedmix {

/// Collects what is wrong and where; what an override has set is located at the override.
class Problems {
 public:
  Problems(std::string file, const std::vector<Override>& overrides)
      : file_(std::move(file)), overrides_(overrides) {}

  /// A problem with the value at the dotted `path`, or with what is missing there.
  void add(const std::string& path, const toml::source_region& at, std::string message);
  /// A problem with the override itself.
  void add(const Override& override, std::string message);
  /// Takes the value at `path` for wrong without a message of its own.
  void spoil(std::string path);
  /// Locates problems with the value at `path` where the one at `source` is, which it comes from.
  void derive(std::string path, std::string source, const toml::source_region& at);
  /// Whether the value at `path` is already known to be wrong.
  bool isSpoiled(std::string_view path) const;

  bool empty() const { return list_.empty(); }
  std::vector<Diagnostic> inFileOrder();

 private:
  SourceLocation locate(std::string_view path, const toml::source_region& at) const;

  std::string file_;
  const std::vector<Override>& overrides_;
  std::vector<Diagnostic> list_;
  std::set<std::string> spoiled_;
  struct Origin {
    std::string path;
    toml::source_region at;
  };
  std::map<std::string, Origin, std::less<>> derived_;
};

/// Parses the text. A syntax error ends it, as nothing behind one can be trusted.
Result<toml::table> parseToml(std::string_view text, const std::string& file);

/// Sets, adds or removes the value an override names.
void applyOverride(toml::table& root, const Override& override, Problems& problems);

/// Adds the keys that the preset `accuracy` gives to the tables that are there and lack them.
void applyPreset(toml::table& root, Problems& problems);

/// Where the value at `path` stands, or the innermost table around it that is there.
toml::source_region sourceOf(const toml::table& root, std::string_view path);

}  // namespace bedmix
