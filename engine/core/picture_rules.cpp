// SPDX-License-Identifier: MIT
#include "engine/core/scene_reader.h"

#include <fmt/format.h>

namespace bedmix {

std::vector<Contradiction> contradictions(const Scene& scene, const PictureSettings& pictures) {
  std::vector<Contradiction> broken;
  const auto add = [&](const char* path, std::vector<std::string> concerns, std::string message) {
    broken.push_back({path, std::move(message), std::move(concerns)});
  };
  const bool hasHeat = scene.effects.find<HeatSettings>() != nullptr;
  std::string_view field;
  for (std::size_t i = 0; i < modelTable<Layer>.size(); ++i) {
    const auto layer = static_cast<Layer>(i);
    if (!pictures.layers.has(layer)) continue;
    const std::string_view name = modelName(layer);
    if (needsGas(layer) && !scene.gas)
      add("pictures.layers", {"gas"},
          fmt::format("the layer '{}' shows the gas, but scene '{}' has none; leave the layer out", name,
                      scene.name));
    if (needsHeat(layer) && !hasHeat)
      add("pictures.layers", {"heat"},
          fmt::format("the layer '{}' shows temperatures, but scene '{}' has no [heat]; leave the layer out",
                      name, scene.name));
    if (!isField(layer)) continue;
    if (!field.empty())
      add("pictures.layers", {},
          fmt::format("the layers '{}' and '{}' colour the same cells; choose one", field, name));
    field = name;
  }
  if (pictures.color == ParticleColor::voidage && !scene.gas)
    add("pictures.color", {"gas"},
        fmt::format("the colour 'voidage' needs the gas, but scene '{}' has none; choose another",
                    scene.name));
  if (pictures.color == ParticleColor::spin && !scene.contacts.friction)
    add("pictures.color", {"contacts.friction"},
        fmt::format(
            "the colour 'spin' needs rotation, but scene '{}' has no [contacts.friction]; choose another",
            scene.name));
  if (needsHeat(pictures.color) && !hasHeat)
    add("pictures.color", {"heat"},
        fmt::format(
            "the colour 'temperature' needs temperatures, but scene '{}' has no [heat]; choose another",
            scene.name));
  if (pictures.color == ParticleColor::content && !scene.effects.find<ReactionSettings>())
    add("pictures.color", {"reaction"},
        fmt::format("the colour 'content' needs a content, but scene '{}' has no [reaction]; choose another",
                    scene.name));
  if (pictures.layers.has(Layer::trails) && pictures.trails.empty())
    add("pictures.layers", {"pictures.trails"},
        "the layer 'trails' follows chosen particles, and none are; give their numbers in trails");
  for (const std::int64_t id : pictures.trails)
    if (id >= scene.particles.count && feedRate(scene) == 0.0)
      add("pictures.trails", {"particles.count"},
          fmt::format("there is no particle {}; scene '{}' has {}, counted from 0", id, scene.name,
                      scene.particles.count));
  return broken;
}

}  // namespace bedmix
