// SPDX-License-Identifier: MIT
#include "render/layers.h"

#include "engine/core/gas_grid.h"

#include <algorithm>
#include <string>

namespace bedmix {

namespace {

Diagnostic unknownLayer(std::string_view name) {
  std::string message = "there is no layer '" + std::string(name) + "'; the layers are:";
  for (const LayerInfo& info : layerTable)
    message += "\n  " + std::string(info.name) + ": " + std::string(info.meaning);
  return {{}, message};
}

std::vector<LayerInfo> gasLayers(Layers layers) {
  std::vector<LayerInfo> found;
  for (std::size_t i = 0; i < layerTable.size(); ++i)
    if (layerTable[i].needsGas && layers.has(static_cast<Layer>(i))) found.push_back(layerTable[i]);
  return found;
}

}  // namespace

Result<Layers> parseLayers(std::string_view list) {
  Layers layers;
  std::vector<Diagnostic> problems;
  for (std::size_t start = 0; start <= list.size();) {
    const std::size_t end = std::min(list.find(',', start), list.size());
    const std::string_view name = list.substr(start, end - start);
    std::size_t i = 0;
    while (i < layerTable.size() && layerTable[i].name != name) ++i;
    if (i < layerTable.size())
      layers.add(static_cast<Layer>(i));
    else
      problems.push_back(unknownLayer(name));
    start = end + 1;
  }
  if (layers.has(Layer::pressure) && layers.has(Layer::voidage))
    problems.push_back({{}, "the layers 'pressure' and 'voidage' colour the same cells; choose one"});
  if (!problems.empty()) return problems;
  return layers;
}

std::vector<Diagnostic> missingFor(const Scene& scene, Layers layers) {
  if (scene.gas) return {};
  std::vector<Diagnostic> problems;
  for (const LayerInfo& info : gasLayers(layers))
    problems.push_back({{},
                        "the layer '" + std::string(info.name) + "' shows the gas, but scene '" + scene.name +
                            "' has none; leave the layer out"});
  return problems;
}

std::vector<Diagnostic> missingFor(const Scene& scene, const Frame& frame, Layers layers) {
  const std::vector<LayerInfo> needed = gasLayers(layers);
  if (needed.empty()) return {};
  const std::size_t cells = makeGasGrid(scene).cells();
  const GasFrame& gas = frame.gas;
  if (gas.voidage.size() == cells && gas.pressure.size() == cells && gas.velocity.size() == cells) return {};
  std::vector<Diagnostic> problems;
  for (const LayerInfo& info : needed)
    problems.push_back({{},
                        "the layer '" + std::string(info.name) + "' needs the gas in " +
                            std::to_string(cells) +
                            " cells, but the frame at t = " + std::to_string(frame.time) + " s holds " +
                            std::to_string(gas.voidage.size()) + "; leave the layer out",
                        Trouble::file});
  return problems;
}

}  // namespace bedmix
