// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/sampling_grid.h"
#include "replay/analysis/analysis.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace bedmix {

/// Grids from a quarter of the scene's columns and rows, at least two of each, every next of about twice as
/// many cells, up to cells of 1.5 particle diameters. A cell is used from half of the particles on that it
/// holds of a settled bed, which fills 0.8 of the plane: 21 in the paper's cells of 24 x 28 mm.
std::vector<SamplingGrid> samplingSeries(const Scene& scene);

/// How indices depend on the size of the cells: means over the second half of the frames, table "sampling", a
/// row a grid; and of the nearest-neighbour index, which has no cells, for comparison.
class SamplingSize final : public Analysis {
 public:
  explicit SamplingSize(const AnalysisInput& input);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override;
  std::vector<FoundNumber> findings() const override;

 private:
  /// Sum of what is defined.
  struct Mean {
    double sum = 0.0;
    std::size_t defined = 0;

    void add(std::optional<double> value);
    std::optional<double> value() const;
  };
  struct Series {
    SamplingGrid grid;
    std::array<Mean, 5> means;  // particles a cell, used cells, Lacey, Ashton, Lacey weighted
  };

  std::size_t frames_, seen_ = 0;
  Period period_;
  std::vector<Series> series_;
  Mean neighbours_;
};

}  // namespace bedmix
