// SPDX-License-Identifier: MIT
#include "engine/core/scene_keys.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/mutations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace bedmix::fuzz {

namespace {

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// TOML or nearly so: extremes, other types, broken texts, and what might fit.
std::string anyValue(Rng& rng) {
  static const char* const values[] = {"0",
                                       "-1",
                                       "-0.0",
                                       "1e308",
                                       "-1e308",
                                       "5e-324",
                                       "1e-300",
                                       "1e400",
                                       "nan",
                                       "inf",
                                       "-inf",
                                       "1_000",
                                       "0x7fffffffffffffff",
                                       "9223372036854775807",
                                       "-9223372036854775808",
                                       "9223372036854775808",
                                       "",
                                       "{}",
                                       "[]",
                                       "[0]",
                                       "[\"walls\"]",
                                       "[[]]",
                                       "[[0, 0]]",
                                       "[[1, 0.012]]",
                                       "[[100000, 1e-300]]",
                                       "[[4, 0.012], [0, 1.0]]",
                                       "[[1e5, 1]]",
                                       "{ count = 1 }",
                                       "true",
                                       "1979-05-27",
                                       "07:32:00",
                                       "\"\"",
                                       "\"\\u0000\"",
                                       "\"\\uD800\"",
                                       "\"\\q\"",
                                       "\"open",
                                       "'''open",
                                       "\"\xc3\xa9\xe6\xbc\xa2\xf0\x9f\x98\x80\"",
                                       "\"\xff\xfe\"",
                                       "# 1",
                                       "1 2",
                                       "0.004",
                                       "1",
                                       "2",
                                       "10",
                                       "100",
                                       "0.5",
                                       "0.1",
                                       "0.048",
                                       "1e-5",
                                       "1e-4",
                                       "1e-3",
                                       "1e-7",
                                       "1e5",
                                       "1e10",
                                       "1e20"};
  const std::size_t choice = below(std::size(values) + 4, rng);
  if (choice < std::size(values)) return values[choice];
  const std::size_t many = std::size_t{1} << below(16, rng);
  if (choice == std::size(values)) return repeated("[", many);
  if (choice == std::size(values) + 1) return '[' + repeated("[1, 0.01],", many) + ']';
  if (choice == std::size(values) + 2) return '"' + repeated("a", many) + '"';
  return repeated("{a=", many);
}

/// A value of the key's own type: one of its names, or a number within its range.
std::string likelyValue(const SceneKey& key, Rng& rng) {
  std::vector<std::string> names;
  for (auto at = key.type.find('"'); at != std::string::npos; at = key.type.find('"', at + 1)) {
    const auto end = key.type.find('"', at + 1);
    names.push_back(key.type.substr(at, end + 1 - at));
    at = end;
  }
  const bool isName = key.type.find("number") == std::string::npos || below(2, rng) == 0;
  if (!names.empty() && isName) return oneOf(names, rng);
  if (key.type == "whole number") return std::to_string(below(100, rng));
  if (key.type.starts_with("number"))
    return tomlNumber(rng.uniform() * std::pow(10.0, static_cast<double>(below(12, rng)) - 6.0));
  return anyValue(rng);
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> found(1);
  for (const char c : text) {
    if (c == '\n')
      found.emplace_back();
    else
      found.back() += c;
  }
  return found;
}

const SceneKey& anyKey(Rng& rng) {
  static const std::vector<SceneKey> keys = sceneKeys();
  return oneOf(keys, rng);
}

/// "[gas]" and a key of it.
std::string keyInItsTable(const SceneKey& key, Rng& rng) {
  const std::string value = below(3, rng) == 0 ? anyValue(rng) : likelyValue(key, rng);
  const auto dot = key.path.rfind('.');
  if (dot == std::string::npos) return fmt::format("{} = {}", key.path, value);
  const std::string table = key.path.substr(0, dot);
  const bool isList = table == "gas.inlets";
  return fmt::format("{}{}{}\n{} = {}", isList ? "[[" : "[", table, isList ? "]]" : "]", key.key.name, value);
}

/// Multiplies the number that the text begins with.
std::string scaled(const std::string& value, Rng& rng) {
  static const double factors[] = {0.0, -1.0, 0.1, 0.5, 2.0, 3.0, 10.0, 1000.0, 1e-6, 1e9, 1.0 + 1e-12};
  char* end = nullptr;
  const double number = std::strtod(value.c_str(), &end);
  if (end == value.c_str()) return anyValue(rng);
  const double factor = below(4, rng) == 0 ? rng.uniform(0.0, 2.0) : oneOf(factors, rng);
  const bool isWhole = value.find_first_of(".eE") == std::string::npos && std::abs(number * factor) < 1e15;
  return isWhole ? fmt::format("{:.0f}{}", number * factor, end) : tomlNumber(number * factor) + end;
}

void mutateLine(std::vector<std::string>& all, std::size_t at, Rng& rng) {
  std::string& line = all[at];
  const auto equals = line.find('=');
  switch (below(equals == std::string::npos ? 4 : 10, rng)) {
    case 0:
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(at));
      return;
    case 1:
      all.insert(all.begin() + static_cast<std::ptrdiff_t>(below(all.size(), rng)), line);
      return;
    case 2:
      line += '\n' + keyInItsTable(anyKey(rng), rng);
      return;
    case 3:
      line = fmt::format("{} = {}", repeated("a.", std::size_t{1} << below(16, rng)) + "a", anyValue(rng));
      return;
    case 4:
      line = fmt::format("{} ={}", anyKey(rng).key.name, line.substr(equals + 1));
      return;
    case 5:
      line = line.substr(0, equals + 1) + anyValue(rng);
      return;
    default:
      line = line.substr(0, equals + 1) + ' ' + scaled(line.substr(equals + 1), rng);
  }
}

}  // namespace

const std::vector<std::string>& seeds() {
  static const std::vector<std::string> bundled = [] {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(BEDMIX_SOURCE_DIR "/assets/scenes"))
      paths.push_back(entry.path());
    std::ranges::sort(paths);
    std::vector<std::string> texts;
    for (const auto& path : paths) {
      std::ifstream in(path);
      texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    return texts;
  }();
  return bundled;
}

void mutate(std::string& input, Rng& rng) {
  if (below(12, rng) == 0) return mutateBytes(input, rng);
  std::vector<std::string> all = lines(input);
  mutateLine(all, below(all.size(), rng), rng);
  input.clear();
  for (const std::string& line : all) input += line + '\n';
}

}  // namespace bedmix::fuzz
