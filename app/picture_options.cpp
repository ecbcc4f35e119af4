// SPDX-License-Identifier: MIT
#include "app/picture_options.h"

#include "engine/core/scene_keys.h"
#include "engine/core/scene_reader.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace bedmix {

namespace {

template <class E>
std::string names() {
  std::string list;
  for (const ModelInfo& info : modelTable<E>) list += fmt::format("{}{}", list.empty() ? "" : ",", info.name);
  return list;
}

/// "a,b" as a TOML list of texts.
std::string textList(std::string_view commaSeparated) {
  std::string list;
  for (std::size_t start = 0; start <= commaSeparated.size();) {
    const std::size_t end = std::min(commaSeparated.find(',', start), commaSeparated.size());
    list += (list.empty() ? "" : ", ") + tomlString(std::string(commaSeparated.substr(start, end - start)));
    start = end + 1;
  }
  return '[' + list + ']';
}

/// The options as keys of [pictures], so that one reader checks both.
std::vector<Override> overridesOf(const PictureOptions& options) {
  std::vector<Override> overrides;
  const auto set = [&](std::string_view key, std::string value, std::string option) {
    if (value.empty()) value = "\"\"";  // nothing at all would remove the key
    overrides.push_back({fmt::format("pictures.{}", key), std::move(value), std::move(option)});
  };
  for (const std::string& setting : options.settings) {
    const std::size_t equals = std::min(setting.find('='), setting.size());
    set(setting.substr(0, equals), setting.substr(std::min(equals + 1, setting.size())),
        "--picture " + setting);
  }
  if (!options.layers.empty()) set("layers", textList(options.layers), "--layers");
  if (!options.color.empty()) {
    const std::size_t colon = std::min(options.color.find(':'), options.color.size());
    set("color", tomlString(options.color.substr(0, colon)), "--color");
    if (colon < options.color.size()) set("classes", options.color.substr(colon + 1), "--color");
  }
  if (!options.background.empty()) set("background", tomlString(options.background), "--background");
  if (!options.trails.empty()) set("trails", '[' + options.trails + ']', "--trails");
  return overrides;
}

}  // namespace

void addStyleOptions(CLI::App& command, PictureOptions& options) {
  command.add_option("--layers", options.layers, "What to show, of " + names<Layer>())->type_name("LIST");
  command
      .add_option("--color", options.color,
                  "What colours the particles, of " + names<ParticleColor>() +
                      "; the last two with a number of classes, e.g. strips:6")
      ->type_name("NAME[:N]");
  command.add_option("--background", options.background, "white, black or a colour like #1a2b3c")
      ->type_name("COLOR");
  command.add_option("--trails", options.trails, "Numbers of particles that leave a trail, e.g. 3,500")
      ->type_name("LIST");
  command
      .add_option("--picture", options.settings,
                  "Another key of the scene's [pictures], e.g. trail_time=0.2; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void addPictureOptions(CLI::App& command, PictureOptions& options) {
  addStyleOptions(command, options);
  command.add_option("--size", options.size, "Size of the picture in pixels, e.g. 1280x720")
      ->type_name("WxH");
}

Result<PaintOptions> paintOptions(const PictureOptions& options, const Scene& scene) {
  PaintOptions paint;
  std::vector<Diagnostic> problems;
  const std::vector<Override> overrides = overridesOf(options);
  const auto styled = readScene(writeScene(scene), scene.name, overrides);
  if (styled) {
    paint.style = styleOf(*styled);
    if (!options.trails.empty()) paint.style.layers.add(Layer::trails);
  } else {
    problems = styled.problems;
  }
  if (!options.size.empty()) {
    auto size = parseSize(options.size);
    if (size) paint.size = *size;
    for (Diagnostic& d : size.problems) {
      d.at.file = "--size";
      problems.push_back(std::move(d));
    }
  }
  if (!problems.empty()) return problems;
  return paint;
}

}  // namespace bedmix
