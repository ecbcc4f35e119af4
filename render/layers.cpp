// SPDX-License-Identifier: MIT
#include "render/layers.h"

#include "engine/core/gas_grid.h"
#include "engine/core/scene_reader.h"

#include <fmt/format.h>

#include <string>

namespace bedmix {

namespace {

/// What the gas is needed for, in words.
std::vector<std::string> gasUses(const Style& style) {
  std::vector<std::string> uses;
  for (std::size_t i = 0; i < modelTable<Layer>.size(); ++i)
    if (const auto layer = static_cast<Layer>(i); needsGas(layer) && style.layers.has(layer))
      uses.push_back(fmt::format("the layer '{}'", modelName(layer)));
  if (style.layers.has(Layer::particles) && style.color == ParticleColor::voidage)
    uses.emplace_back("the colour 'voidage'");
  return uses;
}

}  // namespace

std::vector<Diagnostic> missingFor(const Scene& scene, const Style& style) {
  std::vector<Diagnostic> problems;
  for (Contradiction& c : contradictions(scene, style)) problems.push_back({{}, std::move(c.message)});
  return problems;
}

std::vector<Diagnostic> missingFor(const Scene& scene, const Frame& frame, const Style& style) {
  std::vector<Diagnostic> problems;
  const auto lacks = [&](std::string message) {
    problems.push_back(
        {{}, fmt::format("{} at t = {:g} s; leave it out", message, frame.time), Trouble::file});
  };
  if (const std::vector<std::string> uses = gasUses(style); !uses.empty()) {
    const std::size_t cells = makeGasGrid(scene).cells();
    const GasFrame& gas = frame.gas;
    if (gas.voidage.size() != cells || gas.pressure.size() != cells || gas.velocity.size() != cells)
      for (const std::string& use : uses)
        lacks(fmt::format("{} needs the gas in {} cells, but there are {} in the frame", use, cells,
                          gas.voidage.size()));
    if (style.layers.has(Layer::gasTemperature) && gas.temperature.size() != cells)
      lacks("the layer 'gas-temperature' needs temperatures of the gas, but there are none in the frame");
  }
  if (style.layers.has(Layer::particles) && needsHeat(style.color) &&
      frame.temperature.size() != frame.size())
    lacks("the colour 'temperature' needs temperatures, but there are none in the frame");
  if (style.layers.has(Layer::particles) && style.color == ParticleColor::content &&
      frame.content.size() != frame.size())
    lacks("the colour 'content' needs a content, but there is none in the frame");
  if (style.layers.has(Layer::particles) && style.color == ParticleColor::spin &&
      frame.angularVelocity.size() != frame.size())
    lacks("the colour 'spin' needs angular velocities, but there are none in the frame");
  return problems;
}

}  // namespace bedmix
