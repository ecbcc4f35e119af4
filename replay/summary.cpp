// SPDX-License-Identifier: MIT
#include "replay/summary.h"

#include "engine/core/scene_description.h"
#include "replay/file_trouble.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <system_error>
#include <type_traits>

namespace bedmix {

namespace {

using Json = nlohmann::ordered_json;

/// The settings as JSON, key by key as scene_description.h lists them.
struct JsonVisitor {
  Json& into;

  template <class T>
  static Json tree(T& settings) {
    Json table = Json::object();
    JsonVisitor visitor{table};
    describe(settings, visitor);
    return table;
  }

  template <class T>
  void operator()(const Key& key, T& value) {
    Json& at = into[std::string(key.name)];
    if constexpr (std::is_enum_v<T>)
      at = modelName(value);
    else if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::string>)
      at = tree(value);
    else
      at = value;
  }
  void operator()(const Key& key, StepLength& value) {
    Json& at = into[std::string(key.name)];
    if (value.isAutomatic())
      at = automaticStep;
    else
      at = static_cast<double>(value);
  }
  template <class T>
  void operator()(const Key& key, std::optional<T>& value) {
    if (value) (*this)(key, *value);
  }
  void operator()(const Key& key, Layers& layers) { into[std::string(key.name)] = layerNames(layers); }
  void operator()(const Key& key, Rgba& color) { into[std::string(key.name)] = colorText(color); }
  void operator()(const Key& key, std::vector<std::int64_t>& numbers) {
    into[std::string(key.name)] = numbers;
  }
  void operator()(const Key& key, std::vector<GridSpan>& spans) {
    Json& list = into[std::string(key.name)] = Json::array();
    for (const GridSpan& span : spans) list.push_back({span.count, span.size});
  }
  template <class T>
  void operator()(const Key& key, std::vector<T>& tables) {
    if (tables.empty() && !key.required) return;
    Json& list = into[std::string(key.name)] = Json::array();
    for (T& table : tables) list.push_back(tree(table));
  }
};

std::uint64_t fromHex(const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::invalid_argument("state_hash '" + text + "' is not hexadecimal");
  return value;
}

Retry retryOf(const Json& json) {
  Retry retry;
  for (const auto& [key, value] : json.items()) {
    if (key == "time")
      value.get_to(retry.time);
    else if (key == "from")
      value.get_to(retry.from);
    else if (key == "reason")
      value.get_to(retry.reason);
    else
      retry.settings.emplace_back(key, value.get<double>());
  }
  return retry;
}

}  // namespace

std::optional<Diagnostic> writeSummary(const std::filesystem::path& path, const RunSummary& s,
                                       const Scene& scene) {
  Json retries = Json::array();
  for (const Retry& r : s.retries) {
    Json& retry = retries.emplace_back(Json{{"time", r.time}, {"from", r.from}, {"reason", r.reason}});
    for (const auto& [key, value] : r.settings) retry[key] = value;
  }
  Json stages = Json::object();
  for (const auto& [name, seconds] : s.stages) stages[name] = seconds;
  Scene settings = scene;
  const Json json{{"scene", s.scene},
                  {"seed", s.seed},
                  {"version", s.version},
                  {"commit", s.commit},
                  {"settings", JsonVisitor::tree(settings)},
                  {"simulated_seconds", s.simulatedSeconds},
                  {"wall_seconds", s.wallSeconds},
                  {"steps", s.steps},
                  {"gas_steps", s.gasSteps},
                  {"particle_steps_per_second", s.particleStepsPerSecond},
                  {"stages", stages},
                  {"threads", s.threads},
                  {"simd", s.simd},
                  {"state_hash", fmt::format("{:016x}", s.stateHash)},
                  {"end_reason", s.endReason},
                  {"retries", retries}};

  std::filesystem::path part = path;
  part += ".part";
  std::ofstream file(part, std::ios::binary);
  file << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  file.close();
  std::error_code error;
  if (!file)
    error.assign(errno, std::generic_category());
  else
    std::filesystem::rename(part, path, error);
  if (!error) return std::nullopt;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  return fileTrouble(path, "cannot be written: " + error.message());
}

Result<RunSummary> readSummary(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return fileTrouble(path, std::string("cannot be read: ") + std::strerror(errno));
  try {
    const Json json = Json::parse(file);
    RunSummary s;
    json.at("scene").get_to(s.scene);
    json.at("seed").get_to(s.seed);
    json.at("version").get_to(s.version);
    json.at("commit").get_to(s.commit);
    json.at("simulated_seconds").get_to(s.simulatedSeconds);
    json.at("wall_seconds").get_to(s.wallSeconds);
    json.at("steps").get_to(s.steps);
    json.at("gas_steps").get_to(s.gasSteps);
    json.at("particle_steps_per_second").get_to(s.particleStepsPerSecond);
    for (const auto& [name, seconds] : json.at("stages").items())
      s.stages.emplace_back(name, seconds.get<double>());
    json.at("threads").get_to(s.threads);
    json.at("simd").get_to(s.simd);
    s.stateHash = fromHex(json.at("state_hash").get<std::string>());
    json.at("end_reason").get_to(s.endReason);
    for (const Json& retry : json.value("retries", Json::array())) s.retries.push_back(retryOf(retry));
    return s;
  } catch (const std::exception& e) {
    return fileTrouble(path, std::string("is not a summary of a bedmix run: ") + e.what());
  }
}

}  // namespace bedmix
