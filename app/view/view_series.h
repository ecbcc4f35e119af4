// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/frame.h"
#include "engine/core/gas_grid.h"
#include "engine/core/sampling_grid.h"
#include "engine/core/scene.h"
#include "render/panel/panel_model.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace bedmix {

/// The curves of the panel: mixing indices and, where the scene calls for them, solids flux and pressure
/// drop. Memory is bounded: a long run keeps every second, fourth, ... of its frames.
class ViewSeries {
 public:
  explicit ViewSeries(const Scene& scene);

  /// Frames in order of time; one that is not later is left out.
  void observe(const Frame& frame);
  /// Other sampling cells: the indices of earlier frames are forgotten.
  void resample(const SamplingGrid& grid);
  const SamplingGrid& grid() const { return grid_; }
  std::vector<PanelChart> charts() const;

  static constexpr std::size_t mostPoints = 4096;

 private:
  struct Point {
    float time, lacey, ashton, flux, pressure;  // NaN where undefined
  };

  Scene scene_;
  SamplingGrid grid_;
  std::optional<GasGrid> gas_;
  std::vector<Point> points_;
  std::size_t stride_ = 1, seen_ = 0;
};

}  // namespace bedmix
