// SPDX-License-Identifier: MIT
#include "app/picture_options.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace bedmix {

namespace {

std::string layerNames() {
  std::string names;
  for (const LayerInfo& layer : layerTable)
    names += fmt::format("{}{}", names.empty() ? "" : ",", layer.name);
  return names;
}

}  // namespace

void addPictureOptions(CLI::App& command, PictureOptions& options) {
  command.add_option("--layers", options.layers, "What to show, of " + layerNames())->type_name("LIST");
  command.add_option("--size", options.size, "Size of the picture in pixels, e.g. 1280x720")
      ->type_name("WxH");
}

Result<PaintOptions> paintOptions(const PictureOptions& options, const Scene& scene) {
  PaintOptions paint;
  std::vector<Diagnostic> problems;
  const auto collect = [&](std::vector<Diagnostic> found, const char* option) {
    for (Diagnostic& d : found) {
      d.at.file = option;
      problems.push_back(std::move(d));
    }
  };
  if (!options.layers.empty()) {
    auto layers = parseLayers(options.layers);
    if (layers)
      paint.style.layers = *layers;
    else
      collect(std::move(layers.problems), "--layers");
    collect(missingFor(scene, paint.style.layers), "--layers");
  }
  if (!options.size.empty()) {
    auto size = parseSize(options.size);
    if (size)
      paint.size = *size;
    else
      collect(std::move(size.problems), "--size");
  }
  if (!problems.empty()) return problems;
  return paint;
}

}  // namespace bedmix
