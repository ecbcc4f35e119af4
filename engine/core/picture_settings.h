// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/color.h"
#include "engine/core/models.h"

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace bedmix {

/// What a picture may show, in the order it is drawn.
enum class Layer {
  voidage,
  pressure,
  gasSpeed,
  gasTemperature,
  bubbles,
  particles,
  trails,
  forces,
  sampling,
  counts,
  walls,
  velocity,
  flow,
  gas,
  streamlines,
  hud,
  curve
};

/// What colours the particles.
enum class ParticleColor { tracer, speed, spin, voidage, temperature, content, id, kind, height, strips };

template <>
inline constexpr std::array modelTable<Layer>{
    ModelInfo{"voidage", "voidage as colour of the gas cells", ""},
    ModelInfo{"pressure", "gas pressure as colour of the gas cells", ""},
    ModelInfo{"gas-speed", "speed of the gas as colour of the gas cells", ""},
    ModelInfo{"gas-temperature", "temperature of the gas as colour of the gas cells", ""},
    ModelInfo{"bubbles", "outlines of what has more voidage than pictures.bubble_voidage", ""},
    ModelInfo{"particles", "discs", ""},
    ModelInfo{"trails", "where chosen particles have been", ""},
    ModelInfo{"forces", "force chains: the elastic force of each contact as width of a line", ""},
    ModelInfo{"sampling", "the cells in which tracer is counted, unused ones hatched",
              "Tian et al. (2007), Fig. 5"},
    ModelInfo{"counts", "particles and tracer fraction of each used sampling cell", ""},
    ModelInfo{"walls", "walls, distributor and gas inlets", ""},
    ModelInfo{"velocity", "an arrow per particle", ""},
    ModelInfo{"flow", "an arrow per sampling cell, the mean velocity of its particles",
              "Tian et al. (2007), Fig. 9"},
    ModelInfo{"gas", "an arrow per gas cell", ""},
    ModelInfo{"streamlines", "streamlines of the gas", ""},
    ModelInfo{"hud", "time, indices now, legend, scale bar", ""},
    ModelInfo{"curve", "the mixing indices over time, up to now", ""},
};
template <>
inline constexpr std::array modelTable<ParticleColor>{
    ModelInfo{"tracer", "black for tracer and green for the rest", "Tian et al. (2007)"},
    ModelInfo{"speed", "by speed", ""},
    ModelInfo{"spin", "by angular velocity, counter-clockwise positive", ""},
    ModelInfo{"voidage", "by the voidage at the particle", ""},
    ModelInfo{"temperature", "by temperature", ""},
    ModelInfo{"content", "by what [reaction] has left of the content", ""},
    ModelInfo{"id", "by number", ""},
    ModelInfo{"kind", "by kind of particles", ""},
    ModelInfo{"height", "in classes of the height at the start, each of as many particles", ""},
    ModelInfo{"strips", "in classes by upright strips of the bed at the start, each as wide", ""},
};

/// Whether a layer shows the gas, and so needs one.
constexpr bool needsGas(Layer layer) {
  switch (layer) {
    case Layer::voidage:
    case Layer::pressure:
    case Layer::gasSpeed:
    case Layer::gasTemperature:
    case Layer::bubbles:
    case Layer::gas:
    case Layer::streamlines:
      return true;
    default:
      return false;
  }
}
/// Those that colour the gas cells, which only one can.
inline constexpr std::array fieldLayers{Layer::voidage, Layer::pressure, Layer::gasSpeed,
                                        Layer::gasTemperature};
constexpr bool isField(Layer layer) { return layer <= Layer::gasTemperature; }
/// Whether a layer or colour shows temperatures, and so needs heat.
constexpr bool needsHeat(Layer layer) { return layer == Layer::gasTemperature; }
constexpr bool needsHeat(ParticleColor color) { return color == ParticleColor::temperature; }
/// Whether particles are coloured in classes.
constexpr bool hasClasses(ParticleColor color) { return color >= ParticleColor::height; }

/// A set of layers.
class Layers {
 public:
  constexpr Layers() = default;
  constexpr Layers(std::initializer_list<Layer> layers) {
    for (Layer layer : layers) add(layer);
  }
  constexpr void add(Layer layer) { bits_ |= 1u << static_cast<unsigned>(layer); }
  constexpr bool has(Layer layer) const { return (bits_ >> static_cast<unsigned>(layer) & 1u) != 0; }
  friend constexpr bool operator==(Layers, Layers) = default;

 private:
  unsigned bits_ = 0;
};
/// Their names, in the order they are drawn.
inline std::vector<std::string_view> layerNames(Layers layers) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < modelTable<Layer>.size(); ++i)
    if (layers.has(static_cast<Layer>(i))) names.push_back(modelTable<Layer>[i].name);
  return names;
}
inline constexpr Layers defaultLayers{Layer::particles, Layer::walls, Layer::hud};

/// How the bed is drawn.
struct PictureSettings {
  Layers layers = defaultLayers;
  ParticleColor color = ParticleColor::tracer;
  std::int64_t classes = 4;  // of a colour that has classes
  Rgba ground = white;
  double bubbleVoidage = 0.8;        // where a bubble begins
  std::vector<std::int64_t> trails;  // ids of the particles
  double trailTime = 0.5;            // s, length of a trail
};

}  // namespace bedmix
