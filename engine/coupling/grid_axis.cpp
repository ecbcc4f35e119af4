// SPDX-License-Identifier: MIT
#include "engine/coupling/grid_axis.h"

#include <cmath>
#include <limits>

namespace bedmix {

GridAxis::GridAxis(const std::vector<double>& faces) : faces_(faces) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const int cells = static_cast<int>(faces.size()) - 1;
  double smallest = faces.back();
  for (int i = 0; i < cells; ++i) {
    smallest = std::min(smallest, faces[i + 1] - faces[i]);
    centre_.push_back(0.5 * (faces[i] + faces[i + 1]));
    perSize_.push_back(1.0 / (faces[i + 1] - faces[i]));
    lower_.push_back(i == 0 ? -infinity : faces[i]);
    upper_.push_back(i + 1 == cells ? infinity : faces[i + 1]);
    next_.push_back(std::min(i + 1, cells - 1));
  }
  between_.push_back({0, 0, 0.0, 0.0, 1.0});
  for (int i = 0; i + 1 < cells; ++i)
    between_.push_back({i, i + 1, centre_[i + 1], 1.0 / (centre_[i + 1] - centre_[i]), 0.0});
  between_.push_back({cells - 1, cells - 1, 0.0, 0.0, 1.0});

  const auto bins = static_cast<int>(std::ceil(faces.back() / smallest));
  binsPerLength_ = bins / faces.back();
  lastBin_ = bins - 1;
  int cell = 0;
  for (int bin = 0; bin < bins; ++bin) {
    while (faces[cell + 1] <= bin / binsPerLength_) ++cell;
    cellOfBin_.push_back(cell);
  }
}

}  // namespace bedmix
