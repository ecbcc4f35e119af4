// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/diagnostic.h"
#include "engine/core/frame.h"
#include "engine/core/scene.h"

#include <array>
#include <initializer_list>
#include <string_view>

namespace bedmix {

/// What a picture may show.
enum class Layer { particles, velocity, sampling, gas, pressure, voidage, walls, hud, curve };

struct LayerInfo {
  std::string_view name;
  std::string_view meaning;
  bool needsGas = false;
};
/// In the order of the enumeration.
inline constexpr std::array layerTable{
    LayerInfo{"particles", "discs, black for tracer and green for the rest"},
    LayerInfo{"velocity", "an arrow per particle"},
    LayerInfo{"sampling", "the cells in which tracer is counted"},
    LayerInfo{"gas", "an arrow per gas cell", true},
    LayerInfo{"pressure", "gas pressure as colour of the cells", true},
    LayerInfo{"voidage", "voidage as colour of the cells", true},
    LayerInfo{"walls", "walls, distributor and gas inlets"},
    LayerInfo{"hud", "time, indices now, legend, scale bar"},
    LayerInfo{"curve", "the mixing indices up to now, beside or below the bed"},
};

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
inline constexpr Layers defaultLayers{Layer::particles, Layer::walls, Layer::hud};

/// Reads "particles,velocity,hud". An unknown name is answered with the table; pressure and voidage colour
/// the same cells and exclude each other.
Result<Layers> parseLayers(std::string_view commaSeparated);

/// What of `layers` the scene cannot show: a layer of the gas where there is none.
std::vector<Diagnostic> missingFor(const Scene& scene, Layers layers);
/// The same of a frame: gas fields that are not there or do not fit the scene's grid.
std::vector<Diagnostic> missingFor(const Scene& scene, const Frame& frame, Layers layers);

}  // namespace bedmix
