// SPDX-License-Identifier: MIT
#include "replay/analysis/band.h"

#include "engine/core/index_band.h"
#include "replay/analysis/indices.h"

namespace bedmix {

Band::Band(const AnalysisInput& input)
    : grid_(samplingGrid(input.scene)),
      table_{{"time", "lacey", "lacey_low", "lacey_high", "ashton", "ashton_low", "ashton_high"},
             std::vector<Table::Column>(7)} {}

void Band::accept(const Frame& frame) {
  const CellCounts counts = countCells(frame, grid_);
  const CellStatistics cells = cellStatistics(counts, grid_.minParticles);
  const MixingBand band = mixingBand(counts, grid_.minParticles, static_cast<std::uint64_t>(frame.step));
  table_.append({frame.time, laceyIndex(cells), band.lacey.low, band.lacey.high, ashtonIndex(cells),
                 band.ashton.low, band.ashton.high});
}

std::vector<FoundNumber> Band::findings() const {
  std::vector<FoundNumber> found;
  for (const std::string name : {"lacey", "ashton"}) {
    const auto low = secondHalfMean(*table_.find(name + "_low"));
    const auto high = secondHalfMean(*table_.find(name + "_high"));
    found.push_back({name + "_band_width", low && high ? std::optional(*high - *low) : std::nullopt, ""});
  }
  return found;
}

}  // namespace bedmix
