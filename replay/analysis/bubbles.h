// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/gas_grid.h"
#include "replay/analysis/analysis.h"

#include <optional>
#include <vector>

namespace bedmix {

/// Bubbles: four gas cells or more that share sides and whose voidage is above `pictures.bubble_voidage`, as
/// the layer bubbles draws them, but for what is connected with the outlet or has its centroid above the bed.
/// A bubble's diameter is that of a circle of its area. From one frame to the next it is the one that it
/// shares most area with, if that holds both ways; its rise is what the centroid rises by meanwhile.
///
/// Beside them stand, at the height h and of the diameter d that were found, d = 0.54 (u - u_mf)^0.4 h^0.8
/// g^-0.2 (Darton et al. 1977, no orifices), 0.711 sqrt(g d) of a bubble by itself, and u - u_mf + 0.711
/// sqrt(g d) (Davidson & Harrison 1963); these hold far from walls.
///
/// Tables "bubbles", one row a bubble and frame: time, x, y, diameter, rise (empty where it is new); and
/// "bubble_profile" by stretches of three diameters above the floor: height of the middle, bubbles in a
/// frame, diameter, rise, those that rise through the middle in a second, and the correlations.
class Bubbles final : public Analysis {
 public:
  explicit Bubbles(const AnalysisInput& input);

  void accept(const Frame& frame) override;
  std::vector<NamedTable> tables() const override {
    return {{"bubbles", table_}, {"bubble_profile", profile()}};
  }
  std::vector<FoundNumber> findings() const override;

 private:
  struct Bubble {
    Vec2 centroid{};    // m
    double area = 0.0;  // m2
    std::vector<std::size_t> cells;
  };
  /// Sums over the bubbles of a stretch of height.
  struct Stretch {
    double bubbles = 0.0, diameter = 0.0;
    double followed = 0.0, rise = 0.0;
    double passed = 0.0;
    double darton = 0.0, isolated = 0.0;
  };
  std::vector<Bubble> find(const Frame& frame) const;
  /// For each of the bubbles now the one that it was, or null.
  std::vector<const Bubble*> follow(const std::vector<Bubble>& now) const;
  std::size_t stretchAt(double height) const;
  Table profile() const;

  const Scene& scene_;
  GasGrid grid_;
  double level_;    // voidage at which a bubble begins
  double excess_;   // m/s, gas above what fluidizes
  double spacing_;  // m
  std::vector<Bubble> previous_;
  std::optional<double> time_;  // s, of the frame before
  double duration_ = 0.0, frames_ = 0.0;
  std::vector<Stretch> stretches_;
  Table table_;
};

}  // namespace bedmix
